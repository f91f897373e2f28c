// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyScheme.h
 * The modified Butterfly scheme, piecewise smooth (Mathematics 12): it interpolates.
 *
 * The row of an edge depends on the faces around each of its ends, or in the end's sector. An end
 * is regular if it has six faces inside the surface or three in a sector of a curve. An edge
 * between two regular ends has a row of its own; any other edge has the row of its extraordinary
 * end, or the mean of the rows of both.
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
