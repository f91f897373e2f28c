// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightScheme.h
 * The 4-8 scheme on polygons (Mathematics 12): a quad for each edge that is not fixed.
 *
 * Odd steps: a vertex at the centre of each face; each edge becomes the quad between its ends and
 * the centres beside it, a fixed edge (boundary, crease, line) a triangle on each side. Even steps
 * do the same, but halve fixed edges, whose middle is the centre of the triangles on them.
 *
 * With V vertices on a level, the next one has
 *  - vertices: v stays v; then the centres of faces that have one, in the order of the faces; in
 * even steps then the middle of each fixed edge;
 *  - faces: one for each corner that is the first on its edge, in the order of the corners; in odd
 *    steps one for each corner on a fixed edge, too;
 *  - edges: the fixed ones, in even steps both halves of each; then from each centre to the corners
 *    of its face.
 */
#ifndef SubdivisionObjects_FourEightScheme_h
#define SubdivisionObjects_FourEightScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeFourEightScheme();

}

#endif
