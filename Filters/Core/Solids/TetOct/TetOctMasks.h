// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctMasks.h
 * The weights of d = 3 in the tet/oct scheme (Mathematics 10). First comes linear subdivision; then
 * a point moves to the mean, over the fine cells at it, of a weighted centroid of each (Schaefer,
 * Hakenberg and Warren, figure 4).
 *
 * The fine cells at a point lie in the coarse cells at the vertex or edge that it comes from, so
 * both passes together are one row over the vertices of these. Each coarse cell gives the same
 * share, whatever its place: a row is the sum of the shares over the number of fine cells.
 */
#ifndef SubdivisionObjects_TetOctMasks_h
#define SubdivisionObjects_TetOctMasks_h

#include "Core/Rules/Masks.h"

namespace subdivision
{

namespace tetoct
{
/// Figure 4: the vertex itself, and the other three.
constexpr double TetOwn = -1. / 16.;
constexpr double TetOther = 17. / 48.;
/// The vertex itself, its four neighbours, its opposite.
constexpr double OctOwn = 3. / 8.;
constexpr double OctNear = 1. / 12.;
constexpr double OctFar = 7. / 24.;

/// The share of a coarse tetrahedron in the row of its vertex, for the vertex and for each of the
/// other three. One fine cell of it lies at the vertex: the tetrahedron there.
constexpr double TetVertexOwn = TetOwn + 3. * TetOther / 2.;
constexpr double TetVertexOther = TetOther / 2.;
/// The share of a coarse octahedron: for the vertex, each of its four neighbours, its opposite. One
/// fine cell of it lies at the vertex: an octahedron whose opposite vertex is the centre.
constexpr double OctVertexOwn = OctOwn + 4. * OctNear / 2. + OctFar / 6.;
constexpr double OctVertexNear = OctNear / 2. + OctFar / 6.;
constexpr double OctVertexFar = OctFar / 6.;

/// The share of a coarse tetrahedron in the row of its edge's midpoint, for each end and for each
/// of the other two vertices. Three fine cells of it lie at the midpoint: two tetrahedra and the
/// octahedron.
constexpr double TetEdgeEnd = TetOwn + OctOwn / 2. + 2. * TetOther + OctNear;
constexpr double TetEdgeOther = TetOther + OctNear + OctFar / 2.;
/// The share of a coarse octahedron: for each end, each common neighbour of the ends, each opposite
/// of an end. Two fine cells of each kind lie at the midpoint.
constexpr double OctEdgeCentre = (2. * OctNear + 2. * TetOther) / 6.;
constexpr double OctEdgeEnd =
  OctOwn + TetOwn + OctNear + OctEdgeCentre + OctNear + TetOther + OctFar / 2.;
constexpr double OctEdgeNear = OctEdgeCentre + OctNear + TetOther;
constexpr double OctEdgeFar = OctEdgeCentre + OctFar / 2.;
}

/// Eight tetrahedra and six octahedra: 12 neighbours, two cells of each kind at the edges to them.
constexpr PartedMask RegularVertexMask{
  (8. * tetoct::TetVertexOwn + 6. * tetoct::OctVertexOwn) / 14., 2, { 12, 6, 0 },
  { 2. * (tetoct::TetVertexOther + tetoct::OctVertexNear) / 14., tetoct::OctVertexFar / 14., 0. }
};

/// A regular edge has two cells of each kind: four vertices of its faces, then four opposites of
/// its ends.
constexpr PartedMask RegularEdgeMask{ 2. * (tetoct::TetEdgeEnd + tetoct::OctEdgeEnd) / 14., 2,
  { 4, 4, 0 }, { 2. * tetoct::TetEdgeOther / 14., tetoct::OctEdgeFar / 14., 0. } };
static_assert(tetoct::OctEdgeNear - tetoct::TetEdgeOther < 1e-15 &&
    tetoct::TetEdgeOther - tetoct::OctEdgeNear < 1e-15,
  "a member of the ring has the same weight on both sides of its face");

/// The mask of a vertex that is no control vertex with d = 3. In a control edge of n tetrahedra it
/// has 2n tetrahedra and n octahedra around it; two neighbours along the edge, two in each face,
/// and an opposite in each octahedron.
inline PartedMask TetOctVertexMask(Rule rule, vtkIdType ringSize, LoopWeights weights)
{
  if (rule == Rule::RegularEdge)
  {
    return RegularVertexMask;
  }
  if (rule != Rule::Solid)
  {
    return MakeParted(
      ringSize > 0 ? VertexMask(rule, ringSize, weights) : Mask{ 1., 0. }, ringSize);
  }
  const vtkIdType n = (ringSize - 2) / 3;
  const double cells = 3. * static_cast<double>(n);
  return { (2. * tetoct::TetVertexOwn + tetoct::OctVertexOwn) / 3., 3, { 2, 2 * n, n },
    { tetoct::TetVertexOther / 3., 2. * (tetoct::TetVertexOther + tetoct::OctVertexNear) / cells,
      tetoct::OctVertexFar / cells } };
}

/// The mask of an edge. Each vertex in the ring of a control edge of n tetrahedra lies in two of
/// them.
inline PartedMask TetOctEdgeMask(Rule rule, vtkIdType ringSize)
{
  if (rule == Rule::RegularEdge)
  {
    return RegularEdgeMask;
  }
  if (rule != Rule::Solid || ringSize == 0)
  {
    return MakeParted(EdgeMask(rule, ringSize), ringSize);
  }
  const double cells = 3. * static_cast<double>(ringSize);
  return { tetoct::TetEdgeEnd / 3., 1, { ringSize, 0, 0 },
    { 2. * tetoct::TetEdgeOther / cells, 0., 0. } };
}

}

#endif
