// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeScheme.h
 * Kobbelt's sqrt(3) scheme on triangles (Mathematics 11), uniform.
 *
 * Odd steps: a vertex at the centre of each triangle, edges flipped; fixed edges (boundary,
 * creases, lines) stay. Even steps do the same and cut fixed edges into thirds; a triangle on a
 * fixed edge then gets no centre, the two new points stand in for it.
 *
 * With V vertices, E edges and F faces on a level, the next one has
 *  - vertices: v stays v; the centre of face f is V + f, in even steps V + the number of faces with
 *    a centre before f, and after those two points for each fixed edge, in the order of the edges;
 *  - faces: 3f + i lies across edge i of face f, at the beginning of that edge;
 *  - edges: e is the flipped edge, or the (middle third of the) fixed one; then the outer thirds of
 *    fixed edges; then those inside each face.
 */
#ifndef SubdivisionObjects_SqrtThreeScheme_h
#define SubdivisionObjects_SqrtThreeScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeSqrtThreeScheme();

}

#endif
