// SPDX-License-Identifier: BSD-3-Clause
// The rings of the next level as tables.
#include "Core/Solids/BoxSpline/Refiner.h"

namespace subdivision
{

template <typename Id>
void Refiner<Id>::CountRings()
{
  const auto& parent = this->Parent;
  auto& edges = this->Child.Strata.EdgeRings;
  auto& vertices = this->Child.Strata.VertexRings;
  edges.Offsets = Buffer<Id>(vtkIdType(this->Child.Complex.NumberOfEdges) + 1);
  vertices.Offsets = Buffer<Id>(vtkIdType(this->Child.Complex.NumberOfVertices) + 1);
  ForEach(parent.NumberOfVertices, [&](vtkIdType v)
    { vertices.Offsets[v] = static_cast<Id>(this->Strata.VertexRings.GetSize(v)); });
  ForEach(parent.NumberOfEdges,
    [&](vtkIdType i)
    {
      const Id e = static_cast<Id>(i);
      edges.Offsets[2 * i] = edges.Offsets[2 * i + 1] = this->Emitter.CountHalf(e);
      vertices.Offsets[parent.NumberOfVertices + i] = this->Emitter.CountMidpoint(e);
    });
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      for (int corner = 0; corner < 3; ++corner)
      {
        edges.Offsets[this->Ids.InFace(f, corner)] = this->Emitter.CountInFace(f, corner);
      }
    });
  ForEach(parent.NumberOfTets,
    [&](vtkIdType t) { edges.Offsets[this->Ids.Diagonal(static_cast<Id>(t))] = 4; });
  for (Rings<Id>* rings : { &edges, &vertices })
  {
    CountsToOffsets(rings->Offsets);
    const vtkIdType entries = rings->Offsets[rings->Offsets.size() - 1];
    rings->Members = Buffer<Id>(entries);
    rings->Carriers = Buffer<Id>(this->Full ? entries : 0);
  }
}

template <typename Id>
void Refiner<Id>::MakeRings()
{
  this->CountRings();
  const auto& parent = this->Parent;
  auto write = [this](Rings<Id>& rings, vtkIdType row)
  {
    const Id first = rings.Offsets[row];
    return RingWriter<Id>{ rings.Members.data() + first,
      this->Full ? rings.Carriers.data() + first : nullptr };
  };
  auto& edges = this->Child.Strata.EdgeRings;
  auto& vertices = this->Child.Strata.VertexRings;
  ForEach(parent.NumberOfVertices,
    [&](vtkIdType v)
    {
      auto vertex = write(vertices, v);
      this->Emitter.EmitVertex(static_cast<Id>(v), vertex);
    });
  ForEach(parent.NumberOfEdges,
    [&](vtkIdType e)
    {
      RingWriter<Id> halves[2] = { write(edges, 2 * e), write(edges, 2 * e + 1) };
      auto midpoint = write(vertices, parent.NumberOfVertices + e);
      this->Emitter.EmitAtEdge(static_cast<Id>(e), halves, midpoint);
    });
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      for (int corner = 0; corner < 3; ++corner)
      {
        auto inFace = write(edges, this->Ids.InFace(f, corner));
        this->Emitter.EmitInFace(f, corner, inFace);
      }
    });
  ForEach(parent.NumberOfTets,
    [&](vtkIdType i)
    {
      const Id t = static_cast<Id>(i);
      auto diagonal = write(edges, this->Ids.Diagonal(t));
      this->Emitter.EmitDiagonal(t, diagonal);
    });
}

template class Refiner<int>;
template class Refiner<long long>;

}
