// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MidedgeScheme.h
 * The midedge scheme (Mathematics 12; Zorin, section 4.1): the simplest dual scheme. Each side
 * becomes a vertex, its midpoint.
 *
 * With S sides (DualPlaces.h), the next level has
 *  - vertices: s on side s; then, in odd steps (the first is odd), the old vertex of each chain,
 *    which stays; then the lone vertices (DualPlaces.h);
 *  - faces: f inside face f, with the same corners; the vertex of corner c is the vertex of c's
 *    side; then one for each fan. If it would have two edges only there is none, and the two edges
 *    become one.
 * Two steps cut a boundary as Chaikin's scheme does.
 */
#ifndef SubdivisionObjects_MidedgeScheme_h
#define SubdivisionObjects_MidedgeScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeMidedgeScheme();

}

#endif
