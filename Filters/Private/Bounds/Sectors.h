// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sectors.h
 * The cells on which the limit of a cell depends next to each of its faces: cells beyond a crease
 * do not count there (Mathematics 14).
 */
#ifndef SubdivisionObjects_Sectors_h
#define SubdivisionObjects_Sectors_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Operators/MatrixFactors.h"
#include "Private/Bounds/NestedPieces.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace subdivision
{

class Sectors
{
public:
  /// The factors of a step, the first to be applied first.
  using Step = std::vector<const MatrixFactors::Matrix*>;
  /// Columns and weights of a row.
  using Entries = std::vector<std::pair<vtkIdType, double>>;
  using Mask = NestedPieces::Mask;

  /// `last`: the last step of the pieces, whose rows tell all sectors.
  Sectors(const NestedPieces& pieces, const Step& last);

  /// Visits the points on which the limit next to a point of a cell depends: points of the pieces
  /// at it that belong to its sector. The sector has whole cells, the cell itself among them. For
  /// each of these this calls whole(place), with the place of the point in that cell: all
  /// neighbours of the place count. Of other cells the sector has a face only. There this calls
  /// rest(place) for each neighbour that lies in the face.
  template <typename Whole, typename Rest>
  void ForSector(vtkIdType cell, int point, const Whole& whole, const Rest& rest) const;
  /// A spot is a point in one of its sectors: the places there all have the same limit next to
  /// them.
  vtkIdType GetNumberOfSpots() const { return this->PlacesOfSpots.size(); }
  vtkIdType GetSpot(vtkIdType place) const { return this->Spots[place]; }
  /// Calls act(spot, place) for the spots at the points for which isWanted(point), with one of
  /// their places; in threads, but for points of very many places, each of which takes long.
  template <typename IsWanted, typename Act>
  void ForSpots(const IsWanted& isWanted, const Act& act) const;
  vtkIdType GetCell(vtkIdType place) const { return this->CellsOfPlaces[place]; }
  /// The places that are a point.
  Row<vtkIdType> GetPlaces(vtkIdType point) const { return this->PlacesOfPoints[point]; }
  /// Whether the sector at a place of a cell has tetrahedra.
  bool HasTets(vtkIdType cell, int point) const
  {
    return this->GetSector(cell, this->Pieces.GetLattice(cell).Faces[point]).HasTets;
  }

private:
  /// A set of numbers of faces.
  class FaceSet
  {
  public:
    bool Has(vtkIdType face) const
    {
      return this->Count > 0 && this->Slots[this->Find(face)] == face;
    }
    /// Whether it was not in the set.
    bool Insert(vtkIdType face);

  private:
    std::size_t Find(vtkIdType face) const
    {
      const std::size_t last = this->Slots.size() - 1; // of a power of two
      // Numbers of faces around an edge go up in steps, which would fill some stretches of slots.
      std::size_t at = (static_cast<std::uint64_t>(face) * 0x9E3779B97F4A7C15ULL >> 32U) & last;
      while (this->Slots[at] >= 0 && this->Slots[at] != face)
      {
        at = (at + 1) & last;
      }
      return at;
    }
    std::size_t Count = 0;
    std::vector<vtkIdType> Slots; ///< at most half of them are used
  };

  /// A face of a cell, or all of it, as Masks * cell + mask.
  using Member = vtkIdType;
  /// Faces and cells on which a limit in a face depends. Cells that depend on each other have one.
  struct Sector
  {
    std::vector<Member> Members; ///< with all faces that have the given one
    bool IsOpen = false;         ///< a row was not understood: all belongs to it
    bool HasTets = false;
  };
  /// A face, and one whose limits depend on values in it.
  using Way = std::pair<vtkIdType, vtkIdType>;
  using Ways = std::vector<Way>;
  static constexpr int Masks = 1 << NestedPieces::MostCorners;
  static constexpr vtkIdType ManyPlaces = 64;

  vtkIdType GetFace(vtkIdType cell, Mask mask) const { return this->Faces[Masks * cell + mask]; }
  /// The face of its cell that a place is inside of.
  Mask GetFaceOf(vtkIdType place) const
  {
    const vtkIdType cell = this->CellsOfPlaces[place];
    return this->Pieces.GetLattice(cell).Faces[place - this->Pieces.GetFirstPlace(cell)];
  }
  const Sector& GetSector(vtkIdType cell, Mask face) const
  {
    return this->Found[this->GetFace(cell, face)][this->Numbers[Masks * cell + face]];
  }
  /// act(place) for the places of a cell that are a point.
  template <typename Act>
  void ForPlacesIn(vtkIdType cell, vtkIdType point, const Act& act) const;
  void NumberFaces();
  void ListPlaces();
  void ListSpots();
  void FindInfluences(const Step& last);
  void AddInfluences(vtkIdType point, vtkIdType column, Ways& influences) const;
  void FindSectors(vtkIdType face);
  Sector FollowInfluences(Member holder, Member from, const FaceSet& leftOut, Ways& ways) const;
  static FaceSet FindAhead(Ways& ways, vtkIdType face);
  Mask FindCorners(vtkIdType cell, vtkIdType of, Mask face) const;

  const NestedPieces& Pieces;
  Buffer<vtkIdType> Faces; ///< the number of each face of each cell; -1: no face
  vtkIdType NumberOfFaces = 0;
  Rows<vtkIdType> PlacesOfPoints;
  Buffer<vtkIdType> CellsOfPlaces;
  Rows<Member> Holders; ///< of each face
  /// For each face the larger ones on whose values limits in it depend.
  std::vector<std::vector<Member>> Influences;
  std::vector<char> IsOpen;               ///< of each face, whether a row was not understood
  std::vector<std::vector<Sector>> Found; ///< of each face
  Buffer<int> Numbers;               ///< of each holder, which of the sectors of its face it has
  Buffer<vtkIdType> Spots;           ///< of each place
  Buffer<vtkIdType> PlacesOfSpots;   ///< one of each
  std::vector<vtkIdType> LargeSpots; ///< at points of many places
};

/// Calls act(column, weight) for the columns of a row of the product of some factors.
template <typename Act>
void ForColumns(
  const Sectors::Step& step, std::size_t factors, vtkIdType row, double weight, const Act& act)
{
  const MatrixFactors::Matrix& factor = *step[factors - 1];
  for (vtkIdType e = factor.Offsets[row]; e < factor.Offsets[row + 1]; ++e)
  {
    if (factor.Weights[e] != 0.)
    {
      const double product = weight * factor.Weights[e];
      factors == 1 ? act(factor.Columns[e], product)
                   : ForColumns(step, factors - 1, factor.Columns[e], product, act);
    }
  }
}

/// A row of the product of some factors, of columns that are renamed; each one is there once.
template <typename Rename>
Sectors::Entries GetRow(const Sectors::Step& step, vtkIdType row, const Rename& rename)
{
  Sectors::Entries entries;
  ForColumns(step, step.size(), row, 1.,
    [&](vtkIdType column, double weight)
    {
      const vtkIdType name = rename(column);
      const auto at = std::find_if(
        entries.begin(), entries.end(), [name](const auto& entry) { return entry.first == name; });
      if (at == entries.end())
      {
        entries.emplace_back(name, weight);
        return;
      }
      at->second += weight;
    });
  return entries;
}

template <typename Act>
void Sectors::ForPlacesIn(vtkIdType cell, vtkIdType point, const Act& act) const
{
  const Row<vtkIdType> places = this->PlacesOfPoints[point]; // in the order of cells
  const vtkIdType first = this->Pieces.GetFirstPlace(cell);
  for (const vtkIdType* place = std::lower_bound(places.begin(), places.end(), first);
    place != places.end() && this->CellsOfPlaces[*place] == cell; ++place)
  {
    act(*place);
  }
}

template <typename Whole, typename Rest>
void Sectors::ForSector(vtkIdType cell, int point, const Whole& whole, const Rest& rest) const
{
  const vtkIdType id = this->Pieces.GetPoint(this->Pieces.GetFirstPlace(cell) + point);
  const Sector& sector = this->GetSector(cell, this->Pieces.GetLattice(cell).Faces[point]);
  if (sector.IsOpen)
  {
    std::for_each(this->PlacesOfPoints[id].begin(), this->PlacesOfPoints[id].end(), whole);
    return;
  }
  for (const Member member : sector.Members)
  {
    const vtkIdType other = member / Masks;
    const Mask mask = static_cast<Mask>(member % Masks);
    const NestedPieces::Lattice& its = this->Pieces.GetLattice(other);
    const vtkIdType first = this->Pieces.GetFirstPlace(other);
    this->ForPlacesIn(other, id,
      [&](vtkIdType place)
      {
        if (mask == its.GetWhole())
        {
          whole(place);
          return;
        }
        for (const int neighbour : its.Neighbours[place - first])
        {
          if (!its.Has(neighbour))
          {
            continue; // in another quarter, of which a face has nothing
          }
          const Mask both = its.Close(its.Faces[place - first] | its.Faces[neighbour]);
          if ((both | mask) == mask)
          {
            rest(first + neighbour);
          }
        }
      });
  }
}

template <typename IsWanted, typename Act>
void Sectors::ForSpots(const IsWanted& isWanted, const Act& act) const
{
  ForUnevenRanges(this->GetNumberOfSpots(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType spot = begin; spot < end; ++spot)
      {
        const vtkIdType place = this->PlacesOfSpots[spot];
        const vtkIdType point = this->Pieces.GetPoint(place);
        if (isWanted(point) && this->GetPlaces(point).size() < ManyPlaces)
        {
          act(spot, place);
        }
      }
    });
  for (const vtkIdType spot : this->LargeSpots)
  {
    BetweenLoops::Act();
    const vtkIdType place = this->PlacesOfSpots[spot];
    if (isWanted(this->Pieces.GetPoint(place)))
    {
      act(spot, place);
    }
  }
}

}

#endif
