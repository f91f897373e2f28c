// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctMasks.h
 * The weights of dimension 3 in the tet/oct scheme (Mathematics 10): linear subdivision, then the
 * mean over the fine cells at a point of a centroid (Schaefer, Hakenberg and Warren, figure 4).
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

/// What a coarse tetrahedron gives to its vertex, which has one fine cell in it, the tetrahedron at
/// the corner: for the vertex and for each of the other three.
constexpr double TetVertexOwn = TetOwn + 3. * TetOther / 2.;
constexpr double TetVertexOther = TetOther / 2.;
/// An octahedron, one fine cell, whose far vertex is the centre: for the vertex, each of its four
/// neighbours, its opposite.
constexpr double OctVertexOwn = OctOwn + 4. * OctNear / 2. + OctFar / 6.;
constexpr double OctVertexNear = OctNear / 2. + OctFar / 6.;
constexpr double OctVertexFar = OctFar / 6.;

/// What a tetrahedron gives to the midpoint of its edge, which has three fine cells in it: two
/// tetrahedra and the octahedron: for each end, and for each of the other two.
constexpr double TetEdgeEnd = TetOwn + OctOwn / 2. + 2. * TetOther + OctNear;
constexpr double TetEdgeOther = TetOther + OctNear + OctFar / 2.;
/// An octahedron, two fine cells of each kind: for each end, each common neighbour of the ends,
/// each opposite of an end.
constexpr double OctEdgeCentre = (2. * OctNear + 2. * TetOther) / 6.;
constexpr double OctEdgeEnd =
  OctOwn + TetOwn + OctNear + OctEdgeCentre + OctNear + TetOther + OctFar / 2.;
constexpr double OctEdgeNear = OctEdgeCentre + OctNear + TetOther;
constexpr double OctEdgeFar = OctEdgeCentre + OctFar / 2.;
}

/// A mask for a ring in up to three parts that follow each other.
struct PartedMask
{
  double Own;
  int Parts;
  vtkIdType Sizes[3];
  double Weights[3];
};

/// How many members of the ring of a vertex are opposite to it in octahedra: the last ones.
constexpr vtkIdType CountOpposites(Rule rule, vtkIdType ringSize, bool isControl)
{
  return rule == Rule::RegularEdge ? 6 : rule == Rule::Solid && !isControl ? (ringSize - 2) / 3 : 0;
}

/// Eight tetrahedra and six octahedra: 12 neighbours, two cells of each kind at the edges to them.
constexpr PartedMask RegularVertexMask{
  (8. * tetoct::TetVertexOwn + 6. * tetoct::OctVertexOwn) / 14., 2, { 12, 6, 0 },
  { 2. * (tetoct::TetVertexOther + tetoct::OctVertexNear) / 14., tetoct::OctVertexFar / 14., 0. }
};

/// Two of each: a ring of four, and the opposites of the ends.
constexpr PartedMask RegularEdgeMask{ 2. * (tetoct::TetEdgeEnd + tetoct::OctEdgeEnd) / 14., 2,
  { 4, 4, 0 }, { 2. * tetoct::TetEdgeOther / 14., tetoct::OctEdgeFar / 14., 0. } };
static_assert(tetoct::OctEdgeNear - tetoct::TetEdgeOther < 1e-15 &&
    tetoct::TetEdgeOther - tetoct::OctEdgeNear < 1e-15,
  "a member of the ring has the same weight on both sides of its face");

/// A vertex in a control edge of n tetrahedra: 2n tetrahedra and n octahedra around it; two
/// neighbours along the edge, two in each face, an opposite in each octahedron. Control vertices
/// are not asked for here.
inline PartedMask TetOctVertexMask(Rule rule, vtkIdType ringSize)
{
  if (rule == Rule::RegularEdge)
  {
    return RegularVertexMask;
  }
  if (rule != Rule::Solid)
  {
    const Mask mask = ringSize > 0 ? VertexMask(rule, ringSize) : Mask{ 1., 0. };
    return { mask.Own, 1, { ringSize, 0, 0 }, { mask.Ring, 0., 0. } };
  }
  const vtkIdType n = (ringSize - 2) / 3;
  const double cells = 3. * static_cast<double>(n);
  return { (2. * tetoct::TetVertexOwn + tetoct::OctVertexOwn) / 3., 3, { 2, 2 * n, n },
    { tetoct::TetVertexOther / 3., 2. * (tetoct::TetVertexOther + tetoct::OctVertexNear) / cells,
      tetoct::OctVertexFar / cells } };
}

/// A control edge of n tetrahedra has the weights of its n faces, which have two each.
inline PartedMask TetOctEdgeMask(Rule rule, vtkIdType ringSize)
{
  if (rule == Rule::RegularEdge)
  {
    return RegularEdgeMask;
  }
  if (rule != Rule::Solid || ringSize == 0)
  {
    const Mask mask = EdgeMask(rule, ringSize);
    return { mask.Own, 1, { ringSize, 0, 0 }, { mask.Ring, 0., 0. } };
  }
  const double cells = 3. * static_cast<double>(ringSize);
  return { tetoct::TetEdgeEnd / 3., 1, { ringSize, 0, 0 },
    { 2. * tetoct::TetEdgeOther / cells, 0., 0. } };
}

}

#endif
