// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyScheme.h
 * The modified Butterfly scheme, interpolating, with its boundary and crease rules (SPEC 12).
 */
#ifndef SubdivisionObjects_ButterflyScheme_h
#define SubdivisionObjects_ButterflyScheme_h

#include "SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeButterflyScheme();

}

#endif
