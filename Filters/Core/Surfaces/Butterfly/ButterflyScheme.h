// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyScheme.h
 * The modified Butterfly scheme, piecewise smooth (Mathematics 12): it interpolates.
 *
 * The row of an edge depends on the faces around its two ends, from one sharp edge to the next.
 * Ends are regular if they have six faces inside the surface or three in a sector of a curve; edges
 * between regular ends have rows of their own, all others take those of their ends.
 */
#ifndef SubdivisionObjects_ButterflyScheme_h
#define SubdivisionObjects_ButterflyScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeButterflyScheme();

}

#endif
