// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightScheme.h
 * The 4-8 scheme on polygons (Mathematics 12): a quad for each edge that is not fixed.
 *
 * An odd step puts a vertex at the centre of each face. Each edge becomes the quad between its ends
 * and the two centres beside it, and a fixed edge (FixedEdges.h) a triangle on each side. An even
 * step does the same, but halves fixed edges: a triangle on a fixed edge gets no centre, and the
 * middle of the edge takes its place.
 *
 * With V vertices on a level, the next one has
 *  - vertices: v stays v; then the centres of faces that have one, in the order of the faces; in
 *    even steps then the middle of each fixed edge;
 *  - faces: one for each edge that is not fixed, in the order of the first corners of these edges;
 *    in odd steps also one for each corner on a fixed edge, in the same order of corners;
 *  - edges: the fixed ones, in even steps both halves of each; then the edges from each centre to
 *    the corners of its face, or from the middle in its place to the corner opposite to it.
 */
#ifndef SubdivisionObjects_FourEightScheme_h
#define SubdivisionObjects_FourEightScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeFourEightScheme(bool modifiedBoundary);

}

#endif
