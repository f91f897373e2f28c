// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctComplex.h
 * A level whose solids are tetrahedra and octahedra, and one uniform step of it (Mathematics 10).
 *
 * Only the octahedra are new: all else is stored in SimplicialComplex and Strata. Rules and rings
 * are decided on the control mesh, where all solids are tetrahedra, and inherited. With V vertices,
 * E edges, F faces, T tetrahedra and O octahedra the next level has
 *  - vertices: V + E + o the centre of octahedron o;
 *  - edges: 2E + 3F + 12o + e, a *spoke*, from the centre of o to the midpoint of its edge e;
 *  - faces: 4F + 4t + i cuts vertex i off t; 4F + 4T + 24o + 3k + i joins the centre of o and the
 *    edge that cuts corner i off face k of o;
 *  - tetrahedra: 4t + i at vertex i of t; 4T + 8o + k at face k of o;
 *  - octahedra: t in the middle of t; T + 6o + i at vertex i of o;
 *  and, as in all schemes, its simplices in vertices, edges and faces of before (SolidParts.h).
 *
 * Inside C_3 all edges that are no parts of control edges are regular: two tetrahedra and two
 * octahedra lie at them. All vertices that lie in no control edge are regular too: eight tetrahedra
 * and six octahedra lie at them.
 */
#ifndef SubdivisionObjects_TetOctComplex_h
#define SubdivisionObjects_TetOctComplex_h

#include "Core/Solids/Scheme/Level.h"

#include <memory>

namespace subdivision
{

/**
 * A level of tetrahedra and octahedra. Its rings (Mathematics 10): the ring of a vertex with d = 3
 * has its neighbours by edges and then the vertices opposite to it in its octahedra, with the
 * octahedron as carrier. If the vertex lies in a control edge, the two neighbours along this edge
 * come first. The ring of a regular edge has the vertices opposite to it in its four faces, and
 * then for each of its two octahedra the vertices opposite to its ends, with the octahedron as
 * carrier of both. Regular vertices have Rule::RegularEdge too. All other rings are as in the
 * box-spline scheme.
 */
template <typename Id>
struct TetOctLevel
{
  using IdType = Id;
  /// FaceTets has octahedra too: o as NumberOfTets + o.
  SimplicialComplex<Id> Complex;
  subdivision::Strata<Id> Strata;
  Id NumberOfOctahedra = 0;
  Buffer<Id> OctVertices; ///< 6 for each octahedron, opposite ones side by side
  Buffer<Id> OctEdges;    ///< 12, as in octahedron::EdgeVertices
  Buffer<Id> OctFaces;    ///< 8, as in octahedron::FaceVertices
  EqualCells<Id> EqualOcts;
  /// For each member of the ring of a control vertex the number of tetrahedra at the edge to it,
  /// here called a spoke. It is the same on all levels, so that they share one list.
  std::shared_ptr<const Buffer<Id>> TetsAtSpokes;
  Id NumberOfControlVertices = 0;
  int Steps = 0; ///< since the control level
};

/// The control level, whose cells are tetrahedra.
template <typename Id>
TetOctLevel<Id> MakeTetOctLevel(Level<Id>&& control);

template <typename Id>
TetOctLevel<Id> Refine(const TetOctLevel<Id>& parent, Depth depth);

/// The order in which levels number their vertices (VertexSegments.h).
IdSegments ListTetOctVertices(int steps);

}

#endif
