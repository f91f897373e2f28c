// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctRefiner.h
 * The parts of one uniform step: cells and incidences (TetOctComplex.cxx), rings (TetOctRings.cxx).
 */
#ifndef SubdivisionObjects_TetOctRefiner_h
#define SubdivisionObjects_TetOctRefiner_h

#include "TetOctComplex.h"
#include "TetOctMasks.h"
#include "TetOctTables.h"

namespace subdivision
{

/// The parts of one cell's refinement that lie on its edges and faces.
template <typename Shape, typename Id>
struct CellParts
{
  Id Lattice[Shape::Points];
  Id Halves[Shape::Edges][2];
  Id InFaces[Shape::Faces][3];
  Id Corners[Shape::Faces][3];
  Id Middles[Shape::Faces];
  Id Cell;

  CellParts(const TetOctLevel<Id>& level, const TetOctIds<Id>& ids, Id cell)
    : Cell(cell)
  {
    constexpr bool isTet = Shape::Vertices == 4;
    const auto& complex = level.Complex;
    const vtkIdType i = cell;
    const Id* vertices =
      (isTet ? complex.TetVertices : level.OctVertices).data() + Shape::Vertices * i;
    const Id* edges = (isTet ? complex.TetEdges : level.OctEdges).data() + Shape::Edges * i;
    const Id* faces = (isTet ? complex.TetFaces : level.OctFaces).data() + Shape::Faces * i;
    std::copy(vertices, vertices + Shape::Vertices, this->Lattice);
    for (int e = 0; e < Shape::Edges; ++e)
    {
      this->Lattice[Shape::Vertices + e] = ids.Midpoint(edges[e]);
      const Id half = ids.Half(edges[e], vertices[Shape::EdgeVertices[e][1]]);
      this->Halves[e][1] = half;
      this->Halves[e][0] = half ^ 1;
    }
    if constexpr (!isTet)
    {
      this->Lattice[Shape::Points - 1] = ids.Centre(cell);
    }
    for (int f = 0; f < Shape::Faces; ++f)
    {
      this->Middles[f] = ids.Face(faces[f], 3);
      for (int corner = 0; corner < 3; ++corner)
      {
        const int position =
          complex.VertexInFace(faces[f], vertices[Shape::FaceVertices[f][corner]]);
        this->InFaces[f][corner] = ids.InFace(faces[f], position);
        this->Corners[f][corner] = ids.Face(faces[f], position);
      }
    }
  }

  Id GetEdge(ChildEdgePart part, const TetOctIds<Id>& ids) const
  {
    switch (part.Part)
    {
      case EdgePart::Half:
        return this->Halves[part.Index][part.Corner];
      case EdgePart::InFace:
        return this->InFaces[part.Index][part.Corner];
      default:
        return ids.Spoke(this->Cell, part.Index);
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
        return Shape::Vertices == 4 ? ids.Cut(this->Cell, part.Index)
                                    : ids.Fan(this->Cell, part.Index, part.Corner);
    }
  }
};

/// A cell at a face: where it has the face's vertices, and which of its own faces that is.
template <typename Id>
struct FaceSide
{
  Id Cell = 0; ///< a tetrahedron or an octahedron
  bool IsTet = true;
  int Face = 0;
  int Corners[3] = { 0, 0, 0 };
};

template <typename Id>
class TetOctRefiner
{
public:
  TetOctRefiner(const TetOctLevel<Id>& parent, Depth depth)
    : Level(parent)
    , Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent)
    , Full(depth == Depth::ForRefinement)
  {
  }

  TetOctLevel<Id> Run();

private:
  void Count();
  void MakeEdges();
  void MakeFaces();
  void MakeInnerFaces();
  void SetInnerFace(Id face, const Id vertices[3], const Id edges[3]);
  void MakeFaceCells();
  void MakeCells();
  template <typename Shape>
  void MakeChildren(Id cell, Id firstTet, Id firstOct);
  void MakeEqualCells();
  void MakeEqualSolids();
  void MakeRings();

  template <typename Emit>
  void EmitHalfEdgeRing(Id edge, Id end, const Emit& emit) const;
  FaceSide<Id> GetSide(Id face, Id cell) const;
  template <typename Emit>
  void EmitInFaceRing(Id face, int corner, const FaceSide<Id> sides[2], const Emit& emit) const;
  template <typename Emit>
  void EmitSpokeRing(Id oct, int edge, const Emit& emit) const;
  template <typename Emit>
  void EmitVertexRing(Id vertex, const Emit& emit) const;
  template <typename Emit>
  void EmitMidpointRing(Id edge, const Emit& emit) const;
  template <typename Emit>
  void EmitCentreRing(Id oct, const Emit& emit) const;
  template <typename Act>
  void ForCellsAround(Id edge, const Act& act) const;

  /// Midpoint of the other edge of a face at a vertex.
  Id OtherMidpoint(Id face, Id edge, int corner) const
  {
    const Id* edges = this->Parent.FaceEdges.data() + 3 * vtkIdType(face);
    const Id first = edges[triangle::EdgesAt[corner][0]];
    return this->Ids.Midpoint(first == edge ? edges[triangle::EdgesAt[corner][1]] : first);
  }
  Id OctMidpoint(Id oct, int a, int b) const
  {
    return this->Ids.Midpoint(this->Level.OctEdges[12 * vtkIdType(oct) + octahedron::EdgeOf[a][b]]);
  }
  int VertexInOct(Id oct, Id vertex) const
  {
    return Find(this->Level.OctVertices.data() + 6 * vtkIdType(oct), 6, vertex);
  }
  static int Find(const Id* list, int size, Id wanted)
  {
    int place = 0;
    for (int i = 1; i < size; ++i) // no branches: they could not be foretold
    {
      place += list[i] == wanted ? i : 0;
    }
    return place;
  }

  const TetOctLevel<Id>& Level;
  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const TetOctIds<Id> Ids;
  const bool Full;
  TetOctLevel<Id> Child;
};

}

#endif
