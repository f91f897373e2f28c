// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctChildren.h
 * One tetrahedron or octahedron at a time: the ids of what it becomes on the next level.
 */
#ifndef SubdivisionObjects_TetOctChildren_h
#define SubdivisionObjects_TetOctChildren_h

#include "Core/Solids/TetOct/TetOctComplex.h"
#include "Core/Solids/TetOct/TetOctTables.h"

namespace subdivision
{

/// The lattice points of a cell.
template <typename Shape, typename Id>
struct CellLattice
{
  Id Points[Shape::Points];

  CellLattice(const TetOctIds<Id>& ids, const Id* vertices, const Id* edges, Id cell)
  {
    std::copy(vertices, vertices + Shape::Vertices, this->Points);
    std::transform(edges, edges + Shape::Edges, this->Points + Shape::Vertices,
      [&ids](Id edge) { return ids.Midpoint(edge); });
    if constexpr (Shape::Vertices == 6)
    {
      this->Points[Shape::Points - 1] = ids.Centre(cell);
    }
  }
  CellLattice(const TetOctLevel<Id>& level, const TetOctIds<Id>& ids, Id cell)
    : CellLattice(ids,
        (Shape::Vertices == 4 ? level.Complex.TetVertices : level.OctVertices).data() +
          Shape::Vertices * vtkIdType(cell),
        (Shape::Vertices == 4 ? level.Complex.TetEdges : level.OctEdges).data() +
          Shape::Edges * vtkIdType(cell),
        cell)
  {
  }
};

/// The ids of what one step makes on the edges and faces of one cell, and of its spokes.
/// Corners[f][i] is the child triangle of face f at its vertex i, Middles[f] the one in the middle.
template <typename Shape, typename Id>
struct CellParts
{
  static constexpr bool IsTet = Shape::Vertices == 4;
  CellLattice<Shape, Id> Lattice;
  Id Edges[2 * Shape::Edges + 3 * Shape::Faces + (IsTet ? 0 : Shape::Edges)]; ///< see PlaceOf
  Id Corners[Shape::Faces][3];
  Id Middles[Shape::Faces];
  Id Cell;

  CellParts(const TetOctLevel<Id>& level, const TetOctIds<Id>& ids, Id cell)
    : Lattice(level, ids, cell)
    , Cell(cell)
  {
    const auto& complex = level.Complex;
    const vtkIdType i = cell;
    const Id* vertices = this->Lattice.Points;
    const Id* edges = (IsTet ? complex.TetEdges : level.OctEdges).data() + Shape::Edges * i;
    const Id* faces = (IsTet ? complex.TetFaces : level.OctFaces).data() + Shape::Faces * i;
    for (int e = 0; e < Shape::Edges; ++e)
    {
      const Id half = ids.Half(edges[e], vertices[Shape::EdgeVertices[e][1]]);
      this->Edges[2 * e + 1] = half;
      this->Edges[2 * e] = half ^ 1;
    }
    Id* inFaces = this->Edges + 2 * Shape::Edges;
    if constexpr (!IsTet)
    {
      for (int e = 0; e < Shape::Edges; ++e)
      {
        inFaces[3 * Shape::Faces + e] = ids.Spoke(cell, e);
      }
    }
    for (int f = 0; f < Shape::Faces; ++f)
    {
      this->Middles[f] = ids.Face(faces[f], 3);
      for (int corner = 0; corner < 3; ++corner)
      {
        const int position =
          complex.VertexInFace(faces[f], vertices[Shape::FaceVertices[f][corner]]);
        *inFaces++ = ids.InFace(faces[f], position);
        this->Corners[f][corner] = ids.Face(faces[f], position);
      }
    }
  }

  Id GetFace(ChildFacePart part, const TetOctIds<Id>& ids) const
  {
    switch (part.Part)
    {
      case FacePart::Corner:
        return this->Corners[part.Index][part.Corner];
      case FacePart::Middle:
        return this->Middles[part.Index];
      default:
        return IsTet ? ids.Cut(this->Cell, part.Index)
                     : ids.Fan(this->Cell, part.Index, part.Corner);
    }
  }
};

}

#endif
