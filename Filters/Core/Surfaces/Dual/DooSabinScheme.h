// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DooSabinScheme.h
 * Doo and Sabin's scheme (Mathematics 12; Zorin, figure 9): a dual scheme that generalises the
 * biquadratic B-spline. Each corner of a face becomes a vertex.
 *
 * With C corners, S sides (DualPlaces.h) and B of them open, the next level has
 *  - vertices: c at corner c; C + 2b and C + 2b + 1 on open side b, near the first and the second
 *    end of its half-edge; then those without faces;
 *  - faces: f inside face f, whose corners stay; F + s along side s; then one for each fan. At the
 *    boundary the two points on the open sides belong to the fan's face too. A cycle of two faces
 *    would have a face of two edges: it has none, and the two edges are one.
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
