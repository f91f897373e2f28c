// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeScheme.h
 * Kobbelt's sqrt(3) scheme on triangles (Mathematics 11), uniform.
 *
 * An odd step puts a vertex at the centre of each triangle and flips the edges; fixed edges
 * (FixedEdges.h) stay. An even step does the same, but cuts fixed edges into thirds: a triangle on
 * a fixed edge then gets no centre, and the two new points on the edge take its place.
 *
 * With V vertices, E edges and F faces on a level, the next one has
 *  - vertices: v stays v; the centre of face f is V + f, in even steps V + the number of faces with
 *    a centre before f; then, in even steps, two points for each fixed edge, in the order of the
 *    edges;
 *  - faces: 3f + i lies across edge i of face f, at the beginning of that edge
 *    (SqrtThreeTopology.h);
 *  - edges: e is the flipped edge e, or the fixed edge e or its middle third; then the outer thirds
 *    of fixed edges; then the edges inside each face.
 */
#ifndef SubdivisionObjects_SqrtThreeScheme_h
#define SubdivisionObjects_SqrtThreeScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeSqrtThreeScheme(bool modifiedBoundary);

}

#endif
