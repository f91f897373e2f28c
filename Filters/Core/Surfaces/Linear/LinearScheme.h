// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LinearScheme.h
 * The linear scheme of surfaces: each triangle becomes four, and nothing is smoothed.
 */
#ifndef SubdivisionObjects_SurfaceLinearScheme_h
#define SubdivisionObjects_SurfaceLinearScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeLinearScheme();

}

#endif
