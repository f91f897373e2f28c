// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingEmitter.h
 * Computes the rings of the next level from a level and passes them on member by member. Refiner
 * stores them; ChildRows sums with them at once.
 *
 * Along edges and faces rings are the same in all schemes. Their members inside solids come from
 * the class Split::SolidRings, made from a level:
 *  - CountFaces(rule, size): how many of the first members of the ring of an edge lie on faces,
 * which are their carriers; the others lie in pairs in solids. CountSolids(vertex, rule, size): how
 * many of the last members of the ring of a vertex lie opposite in solids;
 *  - GetMidpointStratum(stratum of an edge), GetInFaceStratum(face, corner);
 *  - CountMidpoint(rule): the size of the ring of an edge's midpoint where the rule alone tells it,
 *    otherwise 0; MostPerCell: how many members of it a solid at the edge has at most;
 *  - CountInFace(face, sizes), CountInFaceAtMost(face): the sizes of the rings of the three edges
 *    inside a face of solids;
 *  - EmitOpposite(solid, vertex, emit): the member that the ring of a vertex has in a solid;
 *  - EmitHalves(solid, ends, halves): the members of the rings of an edge's halves there;
 *  - EmitBeside(edge, face, midpoint), EmitAround(edge, rule, faces, midpoint): the members of
 *    the ring of an edge's midpoint in the solids at one of its faces, and then in all its solids;
 *  - EmitInFace(face, rule, rings): the rings of the three edges inside a face;
 *  - CountInner(shape), EmitInner(shape, solid, edge, emit): the ring of an inner edge;
 *  - CountCentre(shape), EmitCentre(shape, solid, emit): the ring of a centre.
 */
#ifndef SubdivisionObjects_RingEmitter_h
#define SubdivisionObjects_RingEmitter_h

#include "Core/Solids/Scheme/SolidParts.h"
#include "Core/Solids/Strata/Strata.h"

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

template <typename Split>
class RingEmitter
{
public:
  using Id = typename Split::Id;

  explicit RingEmitter(const typename Split::Level& parent)
    : Level(parent)
    , Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent)
    , Solids(parent)
  {
  }

  /// The size of the ring of half an edge.
  Id CountHalf(Id edge) const
  {
    const Row<Id> faces = this->GetFaces(edge);
    Id size = static_cast<Id>(this->Strata.EdgeRings.GetSize(edge) - faces.size());
    for (Id face : faces)
    {
      size += face >= 0 ? 1 : 0;
    }
    return size;
  }
  /// The size of the ring of an edge's midpoint.
  Id CountMidpoint(Id edge) const
  {
    const Rule rule = this->RuleOf(edge);
    if (rule == Rule::Surface)
    {
      return 2 + 2 * this->CountHalf(edge);
    }
    if (const Id size = this->Solids.CountMidpoint(rule))
    {
      return size;
    }
    RingCounter<Id> midpoint;
    RingCounter<Id> halves[2];
    this->EmitAtEdge(edge, halves, midpoint);
    return midpoint.Size;
  }
  /// An upper bound for it, found without searching the solids at the edge.
  Id CountMidpointAtMost(Id edge) const
  {
    const Rule rule = this->RuleOf(edge);
    if (const Id size = this->Solids.CountMidpoint(rule))
    {
      return size;
    }
    Id size = 2;
    for (Id face : this->GetFaces(edge))
    {
      const bool alone = face < 0 || rule == Rule::Surface || rule == Rule::Curve;
      size += 2 +
        (alone ? 0
               : this->Solids.MostPerCell * static_cast<Id>(this->Parent.FaceTets[face].size()));
    }
    return size;
  }
  /// The sizes of the rings of the three edges inside a face.
  void CountInFace(Id face, Id sizes[3]) const
  {
    const Rule rule = this->Strata.Faces[face].GetRule();
    if (rule == Rule::Surface || rule == Rule::Curve)
    {
      std::fill_n(sizes, 3, Id(rule == Rule::Surface ? 2 : 0));
      return;
    }
    this->Solids.CountInFace(face, sizes);
  }
  /// An upper bound for each of them.
  Id CountInFaceAtMost(Id face) const { return this->Solids.CountInFaceAtMost(face); }

  /// Emits the ring of an old vertex: the midpoints of the edges to its neighbours, and the centres
  /// of the solids with its opposites.
  template <typename Emit>
  void EmitVertex(Id vertex, Emit& emit) const
  {
    const Row<Id> carriers = this->Strata.VertexRings.GetCarriers(vertex);
    const Id* firstSolid = carriers.end() -
      this->Solids.CountSolids(vertex, this->Strata.Vertices[vertex].GetRule(), carriers.size());
    for (const Id* edge = carriers.begin(); edge != firstSolid; ++edge)
    {
      emit(this->Ids.Half(*edge, vertex), this->Ids.Midpoint(*edge));
    }
    for (const Id* solid = firstSolid; solid != carriers.end(); ++solid)
    {
      this->Solids.EmitOpposite(*solid, vertex, emit);
    }
  }

  /// Emits the rings of the two halves and of the midpoint of an edge. For each face that carries a
  /// member of the edge's ring, the ring of a half has the midpoint of the other edge of the face
  /// at this half's end; then it has members in the solids that carry members. The ring of the
  /// midpoint has the two ends; for each such face the midpoints of both other edges; and members
  /// in the solids at the edge.
  template <typename Emit>
  void EmitAtEdge(Id edge, Emit (&emitHalves)[2], Emit& emitMidpoint) const;

  /// Emits the rings of the three edges that cut the corners off a face: the corner, the midpoint
  /// opposite to it, and members in the solids at the face. rings.Open(corner, size) gives where
  /// one goes, with an upper bound of its size; rings.Close(corner, emit) says that it is complete.
  template <typename Rings>
  void EmitInFace(Id face, Rings& rings) const
  {
    this->Solids.EmitInFace(face, this->Strata.Faces[face].GetRule(), rings);
  }

  template <typename Shape>
  static constexpr Id CountInner()
  {
    return Split::SolidRings::CountInner(Shape());
  }
  template <typename Shape>
  static constexpr Id CountCentre()
  {
    return Split::SolidRings::CountCentre(Shape());
  }
  template <typename Shape, typename Emit>
  void EmitInner(Id solid, int edge, Emit& emit) const
  {
    this->Solids.EmitInner(Shape(), solid, edge, emit);
  }
  template <typename Shape, typename Emit>
  void EmitCentre(Id solid, Emit& emit) const
  {
    this->Solids.EmitCentre(Shape(), solid, emit);
  }

  Stratum MidpointStratum(Id edge) const
  {
    return this->Solids.GetMidpointStratum(this->Strata.Edges[edge]);
  }
  Stratum InFaceStratum(Id face, int corner) const
  {
    return this->Solids.GetInFaceStratum(face, corner);
  }

  /// The ends of half an edge, of the edge that cuts a corner off a face, and of an inner edge.
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
  template <typename Shape>
  void GetInnerEnds(Id solid, int edge, Id ends[2]) const
  {
    static constexpr auto inner = Shape::GetInnerEdges();
    const Id* edges =
      Split::GetSolids(this->Level, Shape()).Edges + Shape::Edges * vtkIdType(solid);
    for (int i = 0; i < 2; ++i)
    {
      const int between = inner[edge][i] - Shape::Vertices;
      ends[i] = between == Shape::Edges ? this->Ids.template Centre<Shape>(solid)
                                        : this->Ids.Midpoint(edges[between]);
    }
  }

private:
  Rule RuleOf(Id edge) const { return this->Strata.Edges[edge].GetRule(); }
  /// The faces among the carriers of an edge's ring; negative: none.
  Row<Id> GetFaces(Id edge) const
  {
    const Row<Id> carriers = this->Strata.EdgeRings.GetCarriers(edge);
    return { carriers.begin(),
      carriers.begin() + this->Solids.CountFaces(this->RuleOf(edge), carriers.size()) };
  }

  const typename Split::Level& Level;
  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const ChildIds<Split> Ids;
  const typename Split::SolidRings Solids;
};

template <typename Split>
template <typename Emit>
void RingEmitter<Split>::EmitAtEdge(Id edge, Emit (&emitHalves)[2], Emit& emitMidpoint) const
{
  // Copies, which stay in registers.
  Emit halves[2] = { emitHalves[0], emitHalves[1] };
  Emit midpoint = emitMidpoint;
  const auto& parent = this->Parent;
  const Rule rule = this->RuleOf(edge);
  const bool inSolids = rule != Rule::Curve && rule != Rule::Surface;
  const Id ends[2] = { parent.EdgeVertices[2 * vtkIdType(edge)],
    parent.EdgeVertices[2 * vtkIdType(edge) + 1] };
  midpoint(2 * edge, ends[0]);
  midpoint(2 * edge + 1, ends[1]);
  const Row<Id> faces = this->GetFaces(edge);
  for (Id face : faces)
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
    if (inSolids)
    {
      this->Solids.EmitBeside(edge, face, midpoint);
    }
  }
  const Id* last = this->Strata.EdgeRings.GetCarriers(edge).end();
  for (const Id* solid = faces.end(); solid != last; solid += 2)
  {
    this->Solids.EmitHalves(*solid, ends, halves);
  }
  if (inSolids)
  {
    this->Solids.EmitAround(edge, rule, faces, midpoint);
  }
  emitHalves[0] = halves[0];
  emitHalves[1] = halves[1];
  emitMidpoint = midpoint;
}

/// Emits the two members that each ring of an edge inside a face has on the face.
template <typename Id, typename Emit>
void EmitOnFace(
  const SimplicialComplex<Id>& parent, const SkeletonIds<Id>& ids, Id face, int corner, Emit& emit)
{
  emit(ids.Face(face, corner), parent.FaceVertices[3 * vtkIdType(face) + corner]);
  emit(ids.Face(face, 3),
    ids.Midpoint(parent.FaceEdges[3 * vtkIdType(face) + triangle::EdgeOpposite[corner]]));
}

}

#endif
