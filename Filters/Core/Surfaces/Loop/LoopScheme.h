// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopScheme.h
 * Loop's scheme, piecewise smooth (Mathematics 5, 6, 12).
 */
#ifndef SubdivisionObjects_LoopScheme_h
#define SubdivisionObjects_LoopScheme_h

#include "Core/Rules/LoopWeights.h"
#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// `modifiedBoundary`: near curves the rules of Mathematics 12, not of Mathematics 5.
template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeLoopScheme(bool modifiedBoundary, LoopWeights weights);

}

#endif
