// SPDX-License-Identifier: BSD-3-Clause
// The rings of the next level as tables.
#include "Core/Solids/TetOct/TetOctRefiner.h"

namespace subdivision
{

template <typename Id>
void TetOctRefiner<Id>::CountRings()
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
      vertices.Offsets[this->Ids.Midpoint(e)] = this->Emitter.CountMidpoint(e);
    });
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      std::fill_n(edges.Offsets.data() + this->Ids.InFace(f, 0), 3, this->Emitter.CountInFace(f));
    });
  ForEach(this->Level.NumberOfOctahedra,
    [&](vtkIdType i)
    {
      const Id o = static_cast<Id>(i);
      std::fill_n(edges.Offsets.data() + this->Ids.Spoke(o, 0), 12, Id(RegularEdgeRing));
      vertices.Offsets[this->Ids.Centre(o)] = RegularVertexRing;
    });
  for (Rings<Id>* rings : { &edges, &vertices })
  {
    CountsToOffsets(rings->Offsets);
    const vtkIdType entries = rings->Offsets[rings->Offsets.size() - 1];
    rings->Members = Buffer<Id>(entries);
    rings->Carriers = Buffer<Id>(this->Full ? entries : 0);
  }
}

template <typename Id>
void TetOctRefiner<Id>::MakeRings()
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
    [&](vtkIdType i)
    {
      const Id e = static_cast<Id>(i);
      RingWriter<Id> halves[2] = { write(edges, 2 * i), write(edges, 2 * i + 1) };
      auto midpoint = write(vertices, this->Ids.Midpoint(e));
      this->Emitter.EmitAtEdge(e, halves, midpoint);
    });
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      const vtkIdType first = this->Ids.InFace(f, 0);
      RingWriter<Id> corners[3] = { write(edges, first), write(edges, first + 1),
        write(edges, first + 2) };
      this->Emitter.EmitInFace(f, corners);
    });
  ForEach(this->Level.NumberOfOctahedra,
    [&](vtkIdType i)
    {
      const Id o = static_cast<Id>(i);
      for (int e = 0; e < 12; ++e)
      {
        auto spoke = write(edges, this->Ids.Spoke(o, e));
        this->Emitter.EmitSpoke(o, e, spoke);
      }
      auto centre = write(vertices, this->Ids.Centre(o));
      this->Emitter.EmitCentre(o, centre);
    });
}

template class TetOctRefiner<int>;
template class TetOctRefiner<long long>;

}
