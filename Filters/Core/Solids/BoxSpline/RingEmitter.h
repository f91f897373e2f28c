// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingEmitter.h
 * Computes the rings of the next level from a level and passes them on member by member. Refine
 * stores them (RefinedRings.cxx); ChildRows sums with them at once (ChildRows.cxx).
 */
#ifndef SubdivisionObjects_RingEmitter_h
#define SubdivisionObjects_RingEmitter_h

#include "Core/Solids/BoxSpline/Children.h"
#include "Core/Solids/BoxSpline/Refinement.h"

namespace subdivision
{

/// Stores the members of a ring and, if wanted, their carriers.
template <typename Id>
struct RingWriter
{
  Id* Members;
  Id* Carriers; ///< null: not wanted
  void operator()(Id carrier, Id member)
  {
    *this->Members++ = member;
    if (this->Carriers)
    {
      *this->Carriers++ = carrier;
    }
  }
};

/// Stores the members of a ring without carriers.
template <typename Id>
struct MemberWriter
{
  Id* Members;
  void operator()(Id, Id member) { *this->Members++ = member; }
};

template <typename Id>
struct RingCounter
{
  Id Size = 0;
  void operator()(Id, Id) { ++this->Size; }
};

template <typename Id>
class RingEmitter
{
public:
  explicit RingEmitter(const Level<Id>& parent)
    : Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent.Complex)
  {
  }

  /// The size of the ring of half an edge.
  Id CountHalf(Id edge) const
  {
    Id size = 0;
    for (Id face : this->Strata.EdgeRings.GetCarriers(edge))
    {
      size += face >= 0 ? 1 : 0;
    }
    return size;
  }
  /// The size of the ring of an edge's midpoint.
  Id CountMidpoint(Id edge) const
  {
    if (this->Strata.Edges[edge].GetRule() == Rule::Surface)
    {
      return 2 + 2 * this->CountHalf(edge);
    }
    RingCounter<Id> midpoint;
    RingCounter<Id> halves[2];
    this->EmitAtEdge(edge, halves, midpoint);
    return midpoint.Size;
  }
  /// An upper bound for the sizes of the rings of an edge's midpoint and halves, found without
  /// searching the tetrahedra at the edge.
  Id CountAtMost(Id edge) const
  {
    const Rule rule = this->Strata.Edges[edge].GetRule();
    Id size = 2;
    for (Id face : this->Strata.EdgeRings.GetCarriers(edge))
    {
      const bool alone = face < 0 || rule == Rule::Surface || rule == Rule::Curve;
      size += 2 + (alone ? 0 : static_cast<Id>(this->Parent.FaceTets[face].size()));
    }
    return size;
  }
  Id CountInFace(Id face, int corner) const
  {
    if (this->Strata.Faces[face].GetRule() == Rule::Surface)
    {
      return 2;
    }
    RingCounter<Id> counter;
    this->EmitInFace(face, corner, counter);
    return counter.Size;
  }

  /// Emits the rings of the two halves and of the midpoint of an edge. For each face that carries a
  /// member of the edge's ring, the ring of a half has the midpoint of the other edge of the face
  /// at this half's end. The ring of the midpoint has the two ends; for each such face the
  /// midpoints of both other edges; and the other end of each diagonal that ends at the midpoint.
  template <typename Emit>
  void EmitAtEdge(Id edge, Emit (&emitHalves)[2], Emit& emitMidpoint) const;

  /// Emits the ring of the edge that cuts a corner off a face: the corner, the midpoint opposite to
  /// it, and then one or two midpoints in each tetrahedron at the face (FaceCutLinks).
  template <typename Emit>
  void EmitInFace(Id face, int corner, Emit& emit) const;

  /// The diagonal: the equator around it.
  template <typename Emit>
  void EmitDiagonal(Id tet, Emit& emit) const
  {
    for (int q = 0; q < 4; ++q)
    {
      emit(this->Ids.Interior(tet, 4 + q),
        this->Ids.Midpoint(
          this->Parent.TetEdges[6 * vtkIdType(tet) + tetrahedron::EquatorEdges[q]]));
    }
  }

  /// Emits the ring of an old vertex: the midpoints of the edges to the members of its old ring.
  template <typename Emit>
  void EmitVertex(Id vertex, Emit& emit) const
  {
    for (Id edge : this->Strata.VertexRings.GetCarriers(vertex))
    {
      emit(this->Ids.Half(edge, vertex), this->Ids.Midpoint(edge));
    }
  }

  Stratum MidpointStratum(Id edge) const
  {
    const Stratum stratum = this->Strata.Edges[edge];
    return stratum.GetRule() == Rule::RegularEdge ? Stratum(Rule::Solid, stratum.GetType())
                                                  : stratum;
  }
  Stratum InFaceStratum(Id face, int corner) const;

  /// The ends of half an edge, of the edge that cuts a corner off a face, and of the diagonal.
  void GetHalfEnds(Id edge, int half, Id ends[2]) const
  {
    ends[half] = this->Parent.EdgeVertices[2 * vtkIdType(edge) + half];
    ends[1 - half] = this->Ids.Midpoint(edge);
  }
  void GetInFaceEnds(Id face, int corner, Id ends[2]) const
  {
    const Id* edges = this->Parent.FaceEdges.data() + 3 * vtkIdType(face);
    ends[0] = this->Ids.Midpoint(edges[triangle::EdgesAt[corner][0]]);
    ends[1] = this->Ids.Midpoint(edges[triangle::EdgesAt[corner][1]]);
  }
  void GetDiagonalEnds(Id tet, Id ends[2]) const
  {
    const Id* edges = this->Parent.TetEdges.data() + 6 * vtkIdType(tet);
    ends[0] = this->Ids.Midpoint(edges[tetrahedron::MarkedEdges[0]]);
    ends[1] = this->Ids.Midpoint(edges[tetrahedron::MarkedEdges[1]]);
  }

private:
  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const ChildIds<Id> Ids;
};

template <typename Id>
template <typename Emit>
void RingEmitter<Id>::EmitAtEdge(Id edge, Emit (&emitHalves)[2], Emit& emitMidpoint) const
{
  // Copies, which stay in registers.
  Emit halves[2] = { emitHalves[0], emitHalves[1] };
  Emit midpoint = emitMidpoint;
  const auto& parent = this->Parent;
  const Rule rule = this->Strata.Edges[edge].GetRule();
  const Id ends[2] = { parent.EdgeVertices[2 * vtkIdType(edge)],
    parent.EdgeVertices[2 * vtkIdType(edge) + 1] };
  midpoint(2 * edge, ends[0]);
  midpoint(2 * edge + 1, ends[1]);
  for (Id face : this->Strata.EdgeRings.GetCarriers(edge))
  {
    if (face < 0)
    {
      continue;
    }
    const Id* edges = parent.FaceEdges.data() + 3 * vtkIdType(face);
    const int place = parent.EdgeInFace(face, edge);
    const int first = triangle::EdgeVertices[place][0];
    // Whether the face has the edge the other way round.
    const int turned = parent.FaceVertices[3 * vtkIdType(face) + first] == ends[0] ? 0 : 1;
    for (int half = 0; half < 2; ++half)
    {
      const int end = half ^ turned;
      const int corner = triangle::EdgeVertices[place][end];
      const Id member = this->Ids.Midpoint(edges[triangle::EdgeBeside[place][end]]);
      halves[half](this->Ids.Face(face, corner), member);
      if (rule != Rule::Curve)
      {
        midpoint(this->Ids.InFace(face, corner), member);
      }
    }
    if (rule == Rule::Surface || rule == Rule::Curve)
    {
      continue;
    }
    for (Id tet : parent.FaceTets[face])
    {
      const int local = parent.EdgeInTet(tet, edge);
      const int opposite = tetrahedron::OppositeEdge(local);
      // Two faces of the tetrahedron lie at the edge; only the first of them counts it.
      if (tetrahedron::IsMarked(local) &&
        parent.TetFaces[4 * vtkIdType(tet) + tetrahedron::EdgeVertices[opposite][0]] == face)
      {
        midpoint(this->Ids.Diagonal(tet),
          this->Ids.Midpoint(parent.TetEdges[6 * vtkIdType(tet) + opposite]));
      }
    }
  }
  emitHalves[0] = halves[0];
  emitHalves[1] = halves[1];
  emitMidpoint = midpoint;
}

template <typename Id>
template <typename Emit>
void RingEmitter<Id>::EmitInFace(Id face, int corner, Emit& emit) const
{
  const auto& parent = this->Parent;
  const Rule rule = this->Strata.Faces[face].GetRule();
  if (rule == Rule::Curve)
  {
    return;
  }
  const Id vertex = parent.FaceVertices[3 * vtkIdType(face) + corner];
  emit(this->Ids.Face(face, corner), vertex);
  emit(this->Ids.Face(face, 3),
    this->Ids.Midpoint(parent.FaceEdges[3 * vtkIdType(face) + triangle::EdgeOpposite[corner]]));
  if (rule == Rule::Surface)
  {
    return;
  }
  for (Id tet : parent.FaceTets[face])
  {
    const int local = parent.VertexInTet(tet, vertex);
    const Id* edges = parent.TetEdges.data() + 6 * vtkIdType(tet);
    const tetrahedron::FaceCutLink& link =
      tetrahedron::FaceCutLinks[local][parent.FaceInTet(tet, face)];
    emit(this->Ids.Interior(tet, local), this->Ids.Midpoint(edges[link.CutEdge]));
    if (link.HasDiagonal)
    {
      emit(
        this->Ids.Interior(tet, link.DiagonalFace), this->Ids.Midpoint(edges[link.DiagonalEdge]));
    }
  }
}

/// Inside a face between two tetrahedra an edge is regular where both mark the edge it is parallel
/// to: then it lies on the equator of both octahedra.
template <typename Id>
Stratum RingEmitter<Id>::InFaceStratum(Id face, int corner) const
{
  const Stratum stratum = this->Strata.Faces[face];
  if (stratum.GetRule() != Rule::Solid)
  {
    return stratum;
  }
  const Id parallel = this->Parent.FaceEdges[3 * vtkIdType(face) + triangle::EdgeOpposite[corner]];
  for (Id tet : this->Parent.FaceTets[face])
  {
    if (!tetrahedron::IsMarked(this->Parent.EdgeInTet(tet, parallel)))
    {
      return stratum;
    }
  }
  return Stratum(Rule::RegularEdge);
}

}

#endif
