// SPDX-License-Identifier: BSD-3-Clause
// Rings of the next level: emit(carrier, member).
#include "Refiner.h"

namespace subdivision
{

/// Half an edge keeps the parent's ring: the midpoints towards its members.
template <typename Id>
template <typename Emit>
void Refiner<Id>::EmitHalfEdgeRing(Id edge, Id end, const Emit& emit) const
{
  for (Id face : this->Strata.EdgeRings.GetCarriers(edge))
  {
    if (face >= 0)
    {
      const int corner = this->Parent.VertexInFace(face, end);
      emit(this->Ids.Face(face, corner), this->OtherMidpoint(face, edge, corner));
    }
  }
}

/// The edge that cuts a corner off a face: the corner and the opposite midpoint, then what is
/// around it in the tetrahedra beside the face.
template <typename Id>
template <typename Emit>
void Refiner<Id>::EmitInFaceRing(Id face, int corner, const Emit& emit) const
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

/// The midpoint of an edge: its ends; on each face of the edge's ring two midpoints; and the far
/// end of each diagonal that starts here.
template <typename Id>
template <typename Emit>
void Refiner<Id>::EmitMidpointRing(Id edge, const Emit& emit) const
{
  const auto& parent = this->Parent;
  const Rule rule = this->Strata.Edges[edge].GetRule();
  const Id ends[2] = { parent.EdgeVertices[2 * vtkIdType(edge)],
    parent.EdgeVertices[2 * vtkIdType(edge) + 1] };
  emit(2 * edge, ends[0]);
  emit(2 * edge + 1, ends[1]);
  if (rule == Rule::Curve)
  {
    return;
  }
  for (Id face : this->Strata.EdgeRings.GetCarriers(edge))
  {
    if (face < 0)
    {
      continue;
    }
    for (Id end : ends)
    {
      const int corner = parent.VertexInFace(face, end);
      emit(this->Ids.InFace(face, corner), this->OtherMidpoint(face, edge, corner));
    }
    if (rule == Rule::Surface)
    {
      continue;
    }
    for (Id tet : parent.FaceTets[face])
    {
      const int local = parent.EdgeInTet(tet, edge);
      const int opposite = tetrahedron::OppositeEdge(local);
      // Two faces of the tetrahedron lie at the edge; the first of them speaks for it.
      if (tetrahedron::IsMarked(local) &&
        parent.TetFaces[4 * vtkIdType(tet) + tetrahedron::EdgeVertices[opposite][0]] == face)
      {
        emit(this->Ids.Diagonal(tet),
          this->Ids.Midpoint(parent.TetEdges[6 * vtkIdType(tet) + opposite]));
      }
    }
  }
}

template <typename Id>
void Refiner<Id>::CountEdgeRings()
{
  const auto& parent = this->Parent;
  Buffer<Id>& sizes = this->Child.Strata.EdgeRings.Offsets;
  sizes = Buffer<Id>(vtkIdType(this->Child.Complex.NumberOfEdges) + 1);
  ForEach(parent.NumberOfEdges,
    [&](vtkIdType e)
    {
      Id size = 0;
      for (Id face : this->Strata.EdgeRings.GetCarriers(e))
      {
        size += face >= 0 ? 1 : 0;
      }
      sizes[2 * e] = sizes[2 * e + 1] = size;
    });
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      for (int corner = 0; corner < 3; ++corner)
      {
        if (this->Strata.Faces[i].GetRule() == Rule::Surface)
        {
          sizes[this->Ids.InFace(f, corner)] = 2;
          continue;
        }
        Id size = 0;
        this->EmitInFaceRing(f, corner, [&size](Id, Id) { ++size; });
        sizes[this->Ids.InFace(f, corner)] = size;
      }
    });
  ForEach(
    parent.NumberOfTets, [&](vtkIdType t) { sizes[this->Ids.Diagonal(static_cast<Id>(t))] = 4; });
  CountsToOffsets(sizes);
}

template <typename Id>
void Refiner<Id>::MakeEdgeRings()
{
  const auto& parent = this->Parent;
  auto& rings = this->Child.Strata.EdgeRings;
  auto fill = [&](vtkIdType row, const auto& emitRing)
  {
    Id next = rings.Offsets[row];
    emitRing(
      [&](Id carrier, Id member)
      {
        rings.Members[next] = member;
        if (this->Full)
        {
          rings.Carriers[next] = carrier;
        }
        ++next;
      });
  };
  auto all = [&](const auto& act)
  {
    ForEach(parent.NumberOfEdges,
      [&](vtkIdType i)
      {
        const Id e = static_cast<Id>(i);
        for (int half = 0; half < 2; ++half)
        {
          act(2 * i + half,
            [&](const auto& emit)
            { this->EmitHalfEdgeRing(e, parent.EdgeVertices[2 * i + half], emit); });
        }
      });
    ForEach(parent.NumberOfFaces,
      [&](vtkIdType i)
      {
        const Id f = static_cast<Id>(i);
        for (int corner = 0; corner < 3; ++corner)
        {
          act(this->Ids.InFace(f, corner),
            [&](const auto& emit) { this->EmitInFaceRing(f, corner, emit); });
        }
      });
    ForEach(parent.NumberOfTets,
      [&](vtkIdType i)
      {
        const Id t = static_cast<Id>(i);
        act(this->Ids.Diagonal(t),
          [&](const auto& emit)
          {
            for (int q = 0; q < 4; ++q)
            {
              emit(this->Ids.Interior(t, 4 + q),
                this->Ids.Midpoint(parent.TetEdges[6 * i + tetrahedron::EquatorEdges[q]]));
            }
          });
      });
  };
  this->CountEdgeRings();
  const vtkIdType entries = rings.Offsets[this->Child.Complex.NumberOfEdges];
  rings.Members = Buffer<Id>(entries);
  rings.Carriers = Buffer<Id>(this->Full ? entries : 0);
  all(fill);
}

template <typename Id>
void Refiner<Id>::MakeVertexRings()
{
  const auto& parent = this->Parent;
  const auto& old = this->Strata.VertexRings;
  auto& rings = this->Child.Strata.VertexRings;
  const vtkIdType vertices = parent.NumberOfVertices;
  rings.Offsets = Buffer<Id>(vtkIdType(this->Child.Complex.NumberOfVertices) + 1);
  ForEach(vertices, [&](vtkIdType v) { rings.Offsets[v] = static_cast<Id>(old.GetSize(v)); });
  ForEach(parent.NumberOfEdges,
    [&](vtkIdType e)
    {
      const bool isSurface = this->Strata.Edges[e].GetRule() == Rule::Surface;
      Id size = isSurface ? 2 + 2 * static_cast<Id>(this->Strata.EdgeRings.GetSize(e)) : 0;
      if (!isSurface)
      {
        this->EmitMidpointRing(static_cast<Id>(e), [&size](Id, Id) { ++size; });
      }
      rings.Offsets[vertices + e] = size;
    });
  CountsToOffsets(rings.Offsets);
  const vtkIdType entries = rings.Offsets[this->Child.Complex.NumberOfVertices];
  rings.Members = Buffer<Id>(entries);
  rings.Carriers = Buffer<Id>(this->Full ? entries : 0);
  auto put = [&](Id& next, Id carrier, Id member)
  {
    rings.Members[next] = member;
    if (this->Full)
    {
      rings.Carriers[next] = carrier;
    }
    ++next;
  };
  ForEach(vertices,
    [&](vtkIdType v)
    {
      Id next = rings.Offsets[v];
      for (Id edge : old.GetCarriers(v))
      {
        put(next, this->Ids.Half(edge, static_cast<Id>(v)), this->Ids.Midpoint(edge));
      }
    });
  ForEach(parent.NumberOfEdges,
    [&](vtkIdType e)
    {
      Id next = rings.Offsets[vertices + e];
      this->EmitMidpointRing(
        static_cast<Id>(e), [&](Id carrier, Id member) { put(next, carrier, member); });
    });
}

template class Refiner<int>;
template class Refiner<long long>;

}
