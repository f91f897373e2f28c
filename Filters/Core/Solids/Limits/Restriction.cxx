// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/Restriction.h"

#include "Core/Memory/Ids.h"

namespace subdivision
{
namespace
{

/// Flags the simplices that have a vertex flagged in `at`. FlagParts then flags their faces.
template <typename Id>
Buffer<unsigned char> FlagAt(
  const Buffer<unsigned char>& at, const Buffer<Id>& vertices, int corners, vtkIdType size)
{
  Buffer<unsigned char> kept(size);
  ForEach(size,
    [&](vtkIdType i)
    {
      const Id* first = vertices.data() + corners * i;
      kept[i] = std::any_of(first, first + corners, [&](Id v) { return at[v] != 0; });
    });
  return kept;
}
template <typename Id>
void FlagParts(
  const Buffer<unsigned char>& kept, const Buffer<Id>& parts, int count, Buffer<unsigned char>& out)
{
  for (vtkIdType i = 0; i < kept.size(); ++i)
  {
    for (int k = 0; kept[i] && k < count; ++k)
    {
      out[parts[count * i + k]] = 1;
    }
  }
}

}

template <typename Id>
Restriction<Id>::Restriction(const SimplicialComplex<Id>& complex, const Buffer<unsigned char>& at)
{
  Buffer<unsigned char> tets = FlagAt(at, complex.TetVertices, 4, complex.NumberOfTets);
  Buffer<unsigned char> faces = FlagAt(at, complex.FaceVertices, 3, complex.NumberOfFaces);
  Buffer<unsigned char> edges = FlagAt(at, complex.EdgeVertices, 2, complex.NumberOfEdges);
  Buffer<unsigned char> vertices(complex.NumberOfVertices);
  std::copy(at.begin(), at.end(), vertices.begin());
  FlagParts(tets, complex.TetFaces, 4, faces);
  FlagParts(faces, complex.FaceEdges, 3, edges);
  FlagParts(edges, complex.EdgeVertices, 2, vertices);
  this->Vertices = Selection<Id>(vertices);
  this->Edges = Selection<Id>(edges);
  this->Faces = Selection<Id>(faces);
  this->Tets = Selection<Id>(tets);
}

template <typename Id>
SimplicialComplex<Id> Restriction<Id>::Restrict(const SimplicialComplex<Id>& complex) const
{
  SimplicialComplex<Id> part;
  part.NumberOfVertices = static_cast<Id>(this->Vertices.Old.size());
  part.NumberOfEdges = static_cast<Id>(this->Edges.Old.size());
  part.NumberOfFaces = static_cast<Id>(this->Faces.Old.size());
  part.NumberOfTets = static_cast<Id>(this->Tets.Old.size());
  part.EdgeVertices = this->Edges.Pick(complex.EdgeVertices, 2, this->Vertices.New);
  part.FaceVertices = this->Faces.Pick(complex.FaceVertices, 3, this->Vertices.New);
  part.FaceEdges = this->Faces.Pick(complex.FaceEdges, 3, this->Edges.New);
  part.TetVertices = this->Tets.Pick(complex.TetVertices, 4, this->Vertices.New);
  part.TetEdges = this->Tets.Pick(complex.TetEdges, 6, this->Edges.New);
  part.TetFaces = this->Tets.Pick(complex.TetFaces, 4, this->Faces.New);
  part.FaceTets.Offsets = Buffer<Id>(vtkIdType(part.NumberOfFaces) + 1);
  auto forTets = [&](vtkIdType face, const auto& act)
  {
    for (Id tet : complex.FaceTets[this->Faces.Old[face]])
    {
      if (this->Tets.New[tet] >= 0)
      {
        act(this->Tets.New[tet]);
      }
    }
  };
  ForEach(part.NumberOfFaces,
    [&](vtkIdType f)
    {
      Id size = 0;
      forTets(f, [&size](Id) { ++size; });
      part.FaceTets.Offsets[f] = size;
    });
  CountsToOffsets(part.FaceTets.Offsets);
  part.FaceTets.Items = Buffer<Id>(part.FaceTets.Offsets[part.NumberOfFaces]);
  ForEach(part.NumberOfFaces,
    [&](vtkIdType f)
    {
      Id next = part.FaceTets.Offsets[f];
      forTets(f, [&](Id tet) { part.FaceTets.Items[next++] = tet; });
    });
  return part;
}

template <typename Id>
Rings<Id> Restriction<Id>::Restrict(const Rings<Id>& rings, const Selection<Id>& owners,
  const Selection<Id>& carriers, const Selection<Id>& members)
{
  const vtkIdType size = owners.Old.size();
  Rings<Id> part;
  part.Offsets = Buffer<Id>(size + 1);
  auto forEntries = [&](vtkIdType i, const auto& act)
  {
    const Row<Id> oldCarriers = rings.GetCarriers(owners.Old[i]);
    const Row<Id> oldMembers = rings.GetMembers(owners.Old[i]);
    for (vtkIdType k = 0; k < oldMembers.size(); ++k)
    {
      const Id carrier = oldCarriers.begin()[k];
      const Id member = members.New[oldMembers.begin()[k]];
      const Id newCarrier = carrier < 0 ? -1 : carriers.New[carrier];
      if (member >= 0 && (carrier < 0 || newCarrier >= 0))
      {
        act(newCarrier, member);
      }
    }
  };
  ForEach(size,
    [&](vtkIdType i)
    {
      Id count = 0;
      forEntries(i, [&count](Id, Id) { ++count; });
      part.Offsets[i] = count;
    });
  CountsToOffsets(part.Offsets);
  part.Members = Buffer<Id>(part.Offsets[size]);
  part.Carriers = Buffer<Id>(part.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      Id next = part.Offsets[i];
      forEntries(i,
        [&](Id carrier, Id member)
        {
          part.Carriers[next] = carrier;
          part.Members[next++] = member;
        });
    });
  return part;
}

template <typename Id>
Strata<Id> Restriction<Id>::Restrict(const Strata<Id>& strata) const
{
  Strata<Id> part;
  part.Vertices = this->Vertices.Pick(strata.Vertices);
  part.Edges = this->Edges.Pick(strata.Edges);
  part.Faces = this->Faces.Pick(strata.Faces);
  part.VertexRings = Restrict(strata.VertexRings, this->Vertices, this->Edges, this->Vertices);
  part.EdgeRings = Restrict(strata.EdgeRings, this->Edges, this->Faces, this->Vertices);
  return part;
}

template <typename Id>
SemiSharpStages<Id> Restriction<Id>::Restrict(const SemiSharpStages<Id>& creases) const
{
  SemiSharpStages<Id> part;
  if (!creases.Sharpness.empty())
  {
    part.Sharpness = this->Edges.Pick(creases.Sharpness);
  }
  if (!creases.FaceSharpness.empty())
  {
    part.FaceSharpness = this->Faces.Pick(creases.FaceSharpness);
  }
  for (const SharpStage<Id>& stage : creases.Stages)
  {
    part.Stages.push_back({ stage.Until, this->Restrict(stage.Strata) });
  }
  return part;
}

SUBDIVISION_COMPILE(class Restriction);

}
