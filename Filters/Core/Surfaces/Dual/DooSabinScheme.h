// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DooSabinScheme.h
 * Doo and Sabin's scheme (Mathematics 12; Zorin, figure 9): a dual scheme that generalises the
 * biquadratic B-spline. Each corner of a face becomes a vertex.
 *
 * With C corners, F faces, S sides (DualPlaces.h) and B open ones among them, the next level has
 *  - vertices: c at corner c; C + 2b and C + 2b + 1 on open side b, near the beginning and the end
 *    of its half-edge; then the lone vertices (DualPlaces.h);
 *  - faces: f inside face f, with the same corners; F + s along side s; then one for each fan. At
 *    the boundary the two points on the open sides belong to the fan's face too. A cycle of two
 *    faces gets no face, which would have two edges only: instead these two edges become one.
 */
#ifndef SubdivisionObjects_DooSabinScheme_h
#define SubdivisionObjects_DooSabinScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeDooSabinScheme();

}

#endif
