// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/Sectors.h"

#include "Core/Memory/Sorting.h"
#include "Core/Memory/TupleIndex.h"
#include "Core/Memory/UnevenRanges.h"

#include <algorithm>
#include <mutex>

namespace subdivision
{
namespace
{

/// act(mask) for each face of a shape that has a given face, or that is it.
template <typename Act>
void ForFaces(
  const NestedPieces::Lattice& lattice, Sectors::Mask within, Sectors::Mask least, const Act& act)
{
  for (Sectors::Mask mask = 1; mask <= within; ++mask)
  {
    if ((mask & least) == least && (mask | within) == within && lattice.Close(mask) == mask)
    {
      act(mask);
    }
  }
}

}

Sectors::Sectors(const NestedPieces& pieces, const Step& last)
  : Pieces(pieces)
{
  this->NumberFaces();
  this->ListPlaces();
  this->FindInfluences(last);
  this->Found.resize(static_cast<std::size_t>(this->NumberOfFaces));
  this->Numbers = Buffer<int>(this->Faces.size(), -1);
  // Faces of very many cells take long, so each of these comes alone, and reports.
  const auto isLarge = [this](vtkIdType face) { return this->Holders[face].size() > 1024; };
  ForUnevenRanges(this->NumberOfFaces,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType face = begin; face < end; ++face)
      {
        if (!isLarge(face))
        {
          this->FindSectors(face);
        }
      }
    });
  for (const vtkIdType face : InTurn(this->NumberOfFaces))
  {
    if (isLarge(face))
    {
      this->FindSectors(face);
    }
  }
  this->ListSpots();
}

/// Faces with the same corners are one, whatever cells they are of.
void Sectors::NumberFaces()
{
  using Corners = std::array<vtkIdType, NestedPieces::MostCorners>;
  const vtkIdType cells = this->Pieces.GetNumberOfCells();
  Buffer<vtkIdType> offsets(cells + 1, 0);
  const auto forFaces = [this](vtkIdType c, const auto& act)
  {
    const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(c);
    ForFaces(lattice, lattice.GetWhole(), 0, act);
  };
  ForEach(cells, [&](vtkIdType c) { forFaces(c, [&](Mask) { ++offsets[c]; }); });
  CountsToOffsets(offsets);
  Buffer<Corners> faces(offsets[cells]);
  ForEach(cells,
    [&](vtkIdType c)
    {
      vtkIdType next = offsets[c];
      forFaces(c,
        [&](Mask face)
        {
          // The last corner again where there are fewer than four.
          Corners& corners = faces[next++];
          int count = 0;
          for (int k = 0; k < NestedPieces::MostCorners; ++k)
          {
            if (face >> k & 1U)
            {
              corners[count++] = this->Pieces.GetCorner(c, k);
            }
          }
          std::sort(corners.begin(), corners.begin() + count);
          std::fill(corners.begin() + count, corners.end(), corners[count - 1]);
        });
    });
  const TupleNumbers<vtkIdType> numbers = NumberTuples<NestedPieces::MostCorners, vtkIdType>(
    faces, this->Pieces.GetNumberOfPoints(NestedPieces::Steps), 0);
  this->NumberOfFaces = numbers.Representatives.size();
  this->Faces = Buffer<vtkIdType>(Masks * cells, -1);
  ForEach(cells,
    [&](vtkIdType c)
    {
      vtkIdType next = offsets[c];
      forFaces(c, [&](Mask face) { this->Faces[Masks * c + face] = numbers.Numbers[next++]; });
    });
  std::vector<Member> holders;
  holders.reserve(static_cast<std::size_t>(faces.size()));
  for (const vtkIdType c : InTurn(cells))
  {
    forFaces(c, [&](Mask face) { holders.push_back(Masks * c + face); });
  }
  this->Holders = ListByRow<vtkIdType>(
    this->NumberOfFaces, faces.size(), [&](vtkIdType i) { return numbers.Numbers[i]; },
    [&](vtkIdType i) { return holders[i]; });
}

void Sectors::ListPlaces()
{
  this->CellsOfPlaces = Buffer<vtkIdType>(this->Pieces.GetNumberOfPlaces());
  ForEach(this->Pieces.GetNumberOfCells(),
    [this](vtkIdType c)
    {
      std::fill(this->CellsOfPlaces.data() + this->Pieces.GetFirstPlace(c),
        this->CellsOfPlaces.data() + this->Pieces.GetFirstPlace(c + 1), c);
    });
  this->PlacesOfPoints = ListByRow<vtkIdType>(
    this->Pieces.GetNumberOfPoints(NestedPieces::Steps), this->Pieces.GetNumberOfPlaces(),
    [this](vtkIdType place) { return this->Pieces.GetPoint(place); },
    [](vtkIdType place) { return place; });
}

/// Places of one point that have the same sector are one spot.
void Sectors::ListSpots()
{
  Buffer<std::array<vtkIdType, 2>> pairs(this->Pieces.GetNumberOfPlaces());
  ForEach(pairs.size(),
    [&](vtkIdType place)
    {
      const vtkIdType cell = this->CellsOfPlaces[place];
      pairs[place] = { { this->Pieces.GetPoint(place),
        this->Numbers[Masks * cell + this->GetFaceOf(place)] } };
    });
  TupleNumbers<vtkIdType> numbers =
    NumberTuples<2>(pairs, this->Pieces.GetNumberOfPoints(NestedPieces::Steps), 0);
  this->Spots = std::move(numbers.Numbers);
  this->PlacesOfSpots = std::move(numbers.Representatives);
  for (const vtkIdType spot : InTurn(this->GetNumberOfSpots()))
  {
    if (this->GetPlaces(this->Pieces.GetPoint(this->PlacesOfSpots[spot])).size() >= ManyPlaces)
    {
      this->LargeSpots.push_back(spot);
    }
  }
}

/// In the last step rows of all kinds occur, and none that later steps do not have, as the row of a
/// joint with neighbours that have no triangle with it would be.
void Sectors::FindInfluences(const Step& last)
{
  this->Influences.resize(static_cast<std::size_t>(this->NumberOfFaces));
  this->IsOpen.resize(static_cast<std::size_t>(this->NumberOfFaces), 0);
  std::mutex mutex;
  ForUnevenRanges(this->Pieces.GetNumberOfPoints(NestedPieces::Steps),
    [&](vtkIdType begin, vtkIdType end)
    {
      Ways found; // of each face a larger one; -1: a row was not understood
      for (vtkIdType point = begin; point < end; ++point)
      {
        // Inside a cell that is no face all columns are in that cell.
        const Row<vtkIdType> places = this->PlacesOfPoints[point];
        const auto isInside = [this](vtkIdType place)
        {
          return this->GetFaceOf(place) ==
            this->Pieces.GetLattice(this->CellsOfPlaces[place]).GetWhole();
        };
        if (places.size() > 1 || (places.size() == 1 && !isInside(*places.begin())))
        {
          ForColumns(last, last.size(), point, 1.,
            [&](vtkIdType column, double) { this->AddInfluences(point, column, found); });
        }
      }
      // Points of one face find the same.
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      const std::lock_guard<std::mutex> lock(mutex);
      for (const auto& [face, larger] : found)
      {
        if (larger < 0)
        {
          this->IsOpen[face] = 1;
        }
        else
        {
          this->Influences[face].push_back(larger);
        }
      }
    });
  for (std::vector<vtkIdType>& influences : InTurn(this->Influences))
  {
    SortDistinct(influences);
  }
}

/// The face of a point depends on the face which spans that one and a column of the point's row.
void Sectors::AddInfluences(vtkIdType point, vtkIdType column, Ways& influences) const
{
  const Row<vtkIdType> places = this->PlacesOfPoints[point];
  const Row<vtkIdType> others = this->PlacesOfPoints[column];
  const vtkIdType cellOfFirst = this->CellsOfPlaces[*places.begin()];
  const Mask faceOfFirst = this->GetFaceOf(*places.begin());
  const vtkIdType face = this->GetFace(cellOfFirst, faceOfFirst);
  bool isFound = false;
  // Most columns of a row lie in the same face or on its border, in all cells that have it.
  this->ForPlacesIn(cellOfFirst, column,
    [&](vtkIdType other) { isFound = isFound || (this->GetFaceOf(other) & ~faceOfFirst) == 0; });
  if (isFound)
  {
    return;
  }
  const auto add = [&](vtkIdType place, vtkIdType other)
  {
    isFound = true;
    const vtkIdType cell = this->CellsOfPlaces[place];
    const Mask own = this->GetFaceOf(place);
    const Mask both = this->Pieces.GetLattice(cell).Close(own | this->GetFaceOf(other));
    if (both != own)
    {
      influences.emplace_back(face, Masks * cell + both);
    }
  };
  // Through the shorter list: an edge of many cells has many in both.
  if (places.size() <= others.size())
  {
    for (const vtkIdType place : places)
    {
      this->ForPlacesIn(
        this->CellsOfPlaces[place], column, [&](vtkIdType other) { add(place, other); });
    }
  }
  else
  {
    for (const vtkIdType other : others)
    {
      this->ForPlacesIn(
        this->CellsOfPlaces[other], point, [&](vtkIdType place) { add(place, other); });
    }
  }
  // With thirds a row beside a vertex has all that the row of the vertex has.
  if (!isFound && !this->Pieces.HasThirds())
  {
    influences.emplace_back(face, -1);
  }
}

/// The corners of a cell that are corners of a face of another one.
Sectors::Mask Sectors::FindCorners(vtkIdType cell, vtkIdType of, Mask face) const
{
  Mask corners = 0;
  for (int k = 0; k < this->Pieces.GetNumberOfCorners(cell); ++k)
  {
    for (int i = 0; i < this->Pieces.GetNumberOfCorners(of); ++i)
    {
      const bool isSame = this->Pieces.GetCorner(cell, k) == this->Pieces.GetCorner(of, i);
      corners |= isSame && (face >> i & 1U) ? 1U << k : 0U;
    }
  }
  return corners;
}

bool Sectors::FaceSet::Insert(vtkIdType face)
{
  if (2 * this->Count >= this->Slots.size())
  {
    std::vector<vtkIdType> before(std::max<std::size_t>(64, 2 * this->Slots.size()), -1);
    before.swap(this->Slots);
    for (const vtkIdType other : before)
    {
      if (other >= 0)
      {
        this->Slots[this->Find(other)] = other;
      }
    }
  }
  vtkIdType& slot = this->Slots[this->Find(face)];
  const bool isNew = slot != face;
  slot = face;
  this->Count += isNew ? 1 : 0;
  return isNew;
}

/// Finds the sectors of the cells that have a face.
void Sectors::FindSectors(vtkIdType face)
{
  const auto getWhole = [this](Member member)
  {
    const vtkIdType cell = member / Masks;
    return Masks * cell + static_cast<vtkIdType>(this->Pieces.GetLattice(cell).GetWhole());
  };
  const auto isWhole = [&](Member member) { return member == getWhole(member); };
  // Leaves out faces of cells that are members themselves.
  const auto keepLargest = [&](std::vector<Member>& members, Member from)
  {
    FaceSet ofCells;
    const Mask least = static_cast<Mask>(from % Masks);
    for (const Member member : members)
    {
      const vtkIdType cell = member / Masks;
      if (isWhole(member))
      {
        ForFaces(this->Pieces.GetLattice(cell), static_cast<Mask>(member % Masks),
          this->FindCorners(cell, from / Masks, least),
          [&](Mask mask) { ofCells.Insert(this->GetFace(cell, mask)); });
      }
    }
    const auto isCovered = [&](Member member)
    {
      return !isWhole(member) &&
        ofCells.Has(this->GetFace(member / Masks, static_cast<Mask>(member % Masks)));
    };
    members.erase(std::remove_if(members.begin(), members.end(), isCovered), members.end());
  };
  const auto getHolder = [&](Member member, Member from)
  {
    const vtkIdType cell = member / Masks;
    return Masks * cell + this->FindCorners(cell, from / Masks, static_cast<Mask>(from % Masks));
  };
  const Member any = *this->Holders[face].begin();
  // All sectors have the cells on which the face itself depends; these cells have no more.
  Ways waysOfAll;
  const Sector common = this->FollowInfluences(any, any, {}, waysOfAll);
  FaceSet facesOfAll;
  for (const Way& way : waysOfAll)
  {
    facesOfAll.Insert(way.first);
  }
  for (const Member member : common.Members)
  {
    if (isWhole(member))
    {
      this->Numbers[getHolder(member, any)] = 0;
    }
  }
  if (std::any_of(common.Members.begin(), common.Members.end(), isWhole))
  {
    this->Found[face].push_back(common);
    keepLargest(this->Found[face].back().Members, any);
  }
  Turns turns;
  for (const Member from : this->Holders[face])
  {
    turns.Next();
    if (this->Numbers[from] >= 0)
    {
      continue;
    }
    const int number = static_cast<int>(this->Found[face].size());
    const Member whole = getWhole(from);
    Ways ways;
    Sector sector = this->FollowInfluences(from, whole, facesOfAll, ways);
    this->Numbers[from] = number;
    // A cell that depends on this one has the same sector.
    const FaceSet ahead =
      FindAhead(ways, this->GetFace(whole / Masks, static_cast<Mask>(whole % Masks)));
    for (const Member member : sector.Members)
    {
      turns.Next();
      if (isWhole(member) &&
        ahead.Has(this->GetFace(member / Masks, static_cast<Mask>(member % Masks))))
      {
        this->Numbers[getHolder(member, from)] = number;
      }
    }
    sector.Members.insert(sector.Members.end(), common.Members.begin(), common.Members.end());
    sector.IsOpen = sector.IsOpen || common.IsOpen;
    keepLargest(sector.Members, from);
    this->Found[face].push_back(std::move(sector));
  }
}

/// The faces from which ways lead to a face, and itself.
Sectors::FaceSet Sectors::FindAhead(Ways& ways, vtkIdType face)
{
  std::sort(ways.begin(), ways.end());
  FaceSet ahead;
  ahead.Insert(face);
  std::vector<vtkIdType> found = { face };
  Turns turns;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    turns.Next();
    for (auto way = std::lower_bound(ways.begin(), ways.end(), Way(found[i], -1));
      way != ways.end() && way->first == found[i]; ++way)
    {
      if (ahead.Insert(way->second))
      {
        found.push_back(way->second);
      }
    }
  }
  return ahead;
}

/// Follows influences from a face or cell on, over faces that have the face of a holder and are not
/// in `leftOut`. `ways` gets all ways between these faces.
Sectors::Sector Sectors::FollowInfluences(
  Member holder, Member from, const FaceSet& leftOut, Ways& ways) const
{
  const vtkIdType cell = holder / Masks;
  const Mask face = static_cast<Mask>(holder % Masks);
  Sector sector;
  FaceSet known;
  std::vector<vtkIdType> found;
  const auto add = [&](Member member)
  {
    const vtkIdType other = member / Masks;
    const Mask whole = static_cast<Mask>(member % Masks);
    const vtkIdType all = this->GetFace(other, whole);
    if (known.Has(all) || leftOut.Has(all))
    {
      return; // with all its faces
    }
    sector.Members.push_back(member);
    const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(other);
    sector.HasTets =
      sector.HasTets || (this->Pieces.GetDimension(other) == 3 && whole == lattice.GetWhole());
    const Mask least = this->FindCorners(other, cell, face);
    ForFaces(lattice, whole, least,
      [&](Mask mask)
      {
        const vtkIdType number = this->GetFace(other, mask);
        if (leftOut.Has(number) || !known.Insert(number))
        {
          return;
        }
        found.push_back(number);
        ForFaces(lattice, mask, least,
          [&](Mask part) { ways.emplace_back(this->GetFace(other, part), number); });
      });
  };
  add(from);
  Turns turns;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    turns.Next();
    sector.IsOpen = sector.IsOpen || this->IsOpen[found[i]];
    for (const Member member : this->Influences[found[i]])
    {
      ways.emplace_back(this->GetFace(member / Masks, static_cast<Mask>(member % Masks)), found[i]);
      add(member);
    }
  }
  return sector;
}

}
