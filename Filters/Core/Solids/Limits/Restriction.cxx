// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/Restriction.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Flags the things that have a vertex flagged in `at`. FlagParts then flags their faces.
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
  for (const vtkIdType i : InTurn(kept.size()))
  {
    for (int k = 0; kept[i] && k < count; ++k)
    {
      out[parts[count * i + k]] = 1;
    }
  }
}
Buffer<unsigned char> Copy(const Buffer<unsigned char>& flags)
{
  Buffer<unsigned char> copy(flags.size());
  CopyInThreads(flags.data(), flags.size(), copy.data());
  return copy;
}

}

template <typename LevelType>
Restriction<LevelType>::Restriction(const LevelType& level, const Buffer<unsigned char>& at)
  : Whole(level)
  , At(at)
  , Solids(level)
{
  const auto& complex = level.Complex;
  this->EdgesInside = FlagAt(at, complex.EdgeVertices, 2, complex.NumberOfEdges);
  this->FacesInside = FlagAt(at, complex.FaceVertices, 3, complex.NumberOfFaces);
  const Buffer<unsigned char> tets = FlagAt(at, complex.TetVertices, 4, complex.NumberOfTets);
  Buffer<unsigned char> faces = Copy(this->FacesInside);
  Buffer<unsigned char> edges = Copy(this->EdgesInside);
  Buffer<unsigned char> vertices = Copy(at);
  FlagParts(tets, complex.TetFaces, 4, faces);
  if constexpr (SchemeOf<LevelType>::Traits.HasPieces)
  {
    const Buffer<unsigned char> octs = FlagAt(at, level.OctVertices, 6, level.NumberOfOctahedra);
    FlagParts(octs, level.OctFaces, 8, faces);
    this->Octs = Selection<Id>(octs);
  }
  FlagParts(faces, complex.FaceEdges, 3, edges);
  FlagParts(edges, complex.EdgeVertices, 2, vertices);
  this->Vertices = Selection<Id>(vertices);
  this->Edges = Selection<Id>(edges);
  this->Faces = Selection<Id>(faces);
  this->Tets = Selection<Id>(tets);
}

template <typename LevelType>
Restriction<LevelType>::Restriction(const LevelType& level, const PartsOfLevel& kept)
  : Whole(level)
  , At(kept.Vertices)
  , Solids(level)
  , Vertices(kept.Vertices)
  , Edges(kept.Edges)
  , Faces(kept.Faces)
  , Tets(Buffer<unsigned char>(level.Complex.NumberOfTets, 0))
  , Octs(Buffer<unsigned char>(SchemeOf<LevelType>::CountCentres(level), 0))
  , EdgesInside(Copy(kept.Edges))
  , FacesInside(Copy(kept.Faces))
{
}

/// The solids at each face.
template <typename LevelType>
Rows<typename LevelType::IdType> Restriction<LevelType>::RestrictFaceCells() const
{
  const auto& complex = this->Whole.Complex;
  const auto tets = static_cast<Id>(this->Tets.Old.size());
  const auto forSolids = [&](vtkIdType face, const auto& act)
  {
    for (const Id solid : complex.FaceTets[this->Faces.Old[face]])
    {
      const Id oct = solid - complex.NumberOfTets;
      const Id kept = oct < 0 ? this->Tets.New[solid] : this->Octs.New[oct];
      if (kept >= 0)
      {
        act(oct < 0 ? kept : tets + kept);
      }
    }
  };
  const vtkIdType size = this->Faces.Old.size();
  Rows<Id> rows;
  rows.Offsets = Buffer<Id>(size + 1);
  ForEach(size,
    [&](vtkIdType f)
    {
      Id count = 0;
      forSolids(f, [&count](Id) { ++count; });
      rows.Offsets[f] = count;
    });
  CountsToOffsets(rows.Offsets);
  rows.Items = Buffer<Id>(rows.Offsets[size]);
  ForEach(size,
    [&](vtkIdType f)
    {
      Id next = rows.Offsets[f];
      forSolids(f, [&](Id solid) { rows.Items[next++] = solid; });
    });
  return rows;
}

template <typename LevelType>
LevelType Restriction<LevelType>::Restrict() const
{
  const auto& complex = this->Whole.Complex;
  LevelType level;
  auto& part = level.Complex;
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
  part.FaceTets = this->RestrictFaceCells();
  level.Strata = this->Restrict(this->Whole.Strata);
  if constexpr (SchemeOf<LevelType>::Traits.HasPieces)
  {
    level.NumberOfOctahedra = static_cast<Id>(this->Octs.Old.size());
    level.OctVertices = this->Octs.Pick(this->Whole.OctVertices, 6, this->Vertices.New);
    level.OctEdges = this->Octs.Pick(this->Whole.OctEdges, 12, this->Edges.New);
    level.OctFaces = this->Octs.Pick(this->Whole.OctFaces, 8, this->Faces.New);
    level.EqualOcts = { Buffer<Id>(0), Buffer<Id>(0) };
    level.TetsAtSpokes = this->RestrictSpokes(this->Whole.Strata, this->Whole.TetsAtSpokes);
    level.NumberOfControlVertices =
      static_cast<Id>(std::lower_bound(this->Vertices.Old.begin(), this->Vertices.Old.end(),
                        this->Whole.NumberOfControlVertices) -
        this->Vertices.Old.begin());
    level.Steps = this->Whole.Steps;
  }
  return level;
}

/// Calls act(place in the ring, new carrier, new member) for the entries of a ring that are kept.
/// Carriers from `firstSolid` on are solids that are no tetrahedra.
template <typename LevelType>
template <typename Act>
void Restriction<LevelType>::ForEntries(const Rings<Id>& rings, vtkIdType owner,
  vtkIdType firstSolid, const Selection<Id>& carriers, const Act& act) const
{
  const Row<Id> oldCarriers = rings.GetCarriers(owner);
  const Row<Id> oldMembers = rings.GetMembers(owner);
  for (const vtkIdType k : InTurn(oldMembers.size()))
  {
    const Id carrier = oldCarriers.begin()[k];
    const Id member = this->Vertices.New[oldMembers.begin()[k]];
    const Id newCarrier = carrier < 0 ? -1
      : k < firstSolid                ? carriers.New[carrier]
                                      : this->Octs.New[carrier];
    if (member >= 0 && (carrier < 0 || newCarrier >= 0))
    {
      act(k, newCarrier, member);
    }
  }
}

template <typename LevelType>
template <typename FirstSolid>
Rings<typename LevelType::IdType> Restriction<LevelType>::Restrict(const Rings<Id>& rings,
  const Selection<Id>& owners, const Buffer<unsigned char>& isInside, const Selection<Id>& carriers,
  const FirstSolid& firstSolid) const
{
  const vtkIdType size = owners.Old.size();
  Rings<Id> part;
  part.Offsets = Buffer<Id>(size + 1);
  auto forEntries = [&](vtkIdType i, const auto& act)
  {
    const Id old = owners.Old[i];
    if (isInside[old])
    {
      this->ForEntries(rings, old, firstSolid(old), carriers, act);
    }
  };
  ForEach(size,
    [&](vtkIdType i)
    {
      Id count = 0;
      forEntries(i, [&count](vtkIdType, Id, Id) { ++count; });
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
        [&](vtkIdType, Id carrier, Id member)
        {
          part.Carriers[next] = carrier;
          part.Members[next++] = member;
        });
    });
  return part;
}

template <typename LevelType>
Buffer<Stratum> Restriction<LevelType>::Restrict(const Buffer<Stratum>& strata,
  const Selection<Id>& owners, const Buffer<unsigned char>& isInside, Rule atBorder) const
{
  Buffer<Stratum> part = owners.Pick(strata);
  ForEach(part.size(),
    [&](vtkIdType i) { part[i] = isInside[owners.Old[i]] ? part[i] : Stratum(atBorder); });
  return part;
}

template <typename LevelType>
Strata<typename LevelType::IdType> Restriction<LevelType>::Restrict(const Strata<Id>& strata) const
{
  Strata<Id> part;
  part.TakeChoices(strata);
  part.Sectors = CutSectorEdges(
    strata.Sectors,
    [this](Id edge) { return this->EdgesInside[edge] ? this->Edges.New[edge] : Id(-1); },
    [this](Id vertex) { return this->Vertices.New[vertex]; });
  part.Vertices = this->Restrict(strata.Vertices, this->Vertices, this->At, Rule::Corner);
  part.Edges = this->Restrict(strata.Edges, this->Edges, this->EdgesInside, Rule::Curve);
  part.Faces = this->Restrict(strata.Faces, this->Faces, this->FacesInside, Rule::Surface);
  part.VertexRings = this->Restrict(strata.VertexRings, this->Vertices, this->At, this->Edges,
    [&](Id v)
    {
      const vtkIdType size = strata.VertexRings.GetSize(v);
      return size - this->Solids.CountSolids(v, strata.Vertices[v].GetRule(), size);
    });
  part.EdgeRings =
    this->Restrict(strata.EdgeRings, this->Edges, this->EdgesInside, this->Faces, [&](Id e)
      { return this->Solids.CountFaces(strata.Edges[e].GetRule(), strata.EdgeRings.GetSize(e)); });
  return part;
}

template <typename LevelType>
std::shared_ptr<const Buffer<typename LevelType::IdType>> Restriction<LevelType>::RestrictSpokes(
  const Strata<Id>& strata, const std::shared_ptr<const Buffer<Id>>& spokes) const
{
  if constexpr (!SchemeOf<LevelType>::Traits.HasPieces)
  {
    return spokes;
  }
  else
  {
    std::vector<Id> kept;
    for (const Id v : this->Vertices.Old)
    {
      if (v < this->Whole.NumberOfControlVertices && this->At[v])
      {
        const Rings<Id>& rings = strata.VertexRings;
        this->ForEntries(rings, v, rings.GetSize(v), this->Edges,
          [&](vtkIdType k, Id, Id) { kept.push_back((*spokes)[rings.Offsets[v] + k]); });
      }
    }
    auto part = std::make_shared<Buffer<Id>>(static_cast<vtkIdType>(kept.size()));
    std::copy(kept.begin(), kept.end(), part->begin());
    return part;
  }
}

template class Restriction<Level<int>>;
template class Restriction<Level<long long>>;
template class Restriction<TetOctLevel<int>>;
template class Restriction<TetOctLevel<long long>>;

}
