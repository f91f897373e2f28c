// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/Sectors.h"

#include "Core/Memory/Sorting.h"
#include "Core/Memory/TupleIndex.h"

#include <algorithm>
#include <iterator>

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
  for (const vtkIdType c : InTurn(pieces.GetNumberOfCells()))
  {
    this->FirstSectors.push_back(static_cast<vtkIdType>(this->Found.size()));
    this->Found.resize(this->Found.size() + pieces.GetLattice(c).GetWhole());
  }
  ForEach(pieces.GetNumberOfCells(),
    [this](vtkIdType c)
    {
      const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(c);
      ForFaces(lattice, lattice.GetWhole(), 0,
        [&](Mask face)
        {
          this->Found[this->FirstSectors[c] + static_cast<int>(face) - 1] =
            this->FindSector(c, face);
        });
    });
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

/// In the last step rows of all kinds occur, and none that do not come again, such as that of a
/// joint with neighbours that have no triangle with it.
void Sectors::FindInfluences(const Step& last)
{
  this->Influences.resize(static_cast<std::size_t>(this->NumberOfFaces));
  this->IsOpen.resize(static_cast<std::size_t>(this->NumberOfFaces), 0);
  for (const vtkIdType point : InTurn(this->Pieces.GetNumberOfPoints(NestedPieces::Steps)))
  {
    // Inside a cell that is no face all columns are in that cell.
    const Row<vtkIdType> places = this->PlacesOfPoints[point];
    if (places.size() > 1 || (places.size() == 1 && !this->IsInside(*places.begin())))
    {
      ForColumns(last, last.size(), point, 1.,
        [&](vtkIdType column, double) { this->AddInfluences(point, column); });
    }
  }
  for (std::vector<vtkIdType>& influences : InTurn(this->Influences))
  {
    SortDistinct(influences);
  }
}

bool Sectors::IsInside(vtkIdType place) const
{
  const vtkIdType cell = this->CellsOfPlaces[place];
  const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(cell);
  return lattice.Faces[place - this->Pieces.GetFirstPlace(cell)] == lattice.GetWhole();
}

/// What lies between a point and a column of its row counts for the face that has the point.
void Sectors::AddInfluences(vtkIdType point, vtkIdType column)
{
  vtkIdType face = -1;
  bool isFound = false;
  for (const vtkIdType place : this->PlacesOfPoints[point])
  {
    const vtkIdType cell = this->CellsOfPlaces[place];
    const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(cell);
    const Mask own = lattice.Faces[place - this->Pieces.GetFirstPlace(cell)];
    face = this->GetFace(cell, own);
    for (const vtkIdType other : this->PlacesOfPoints[column])
    {
      if (this->CellsOfPlaces[other] == cell)
      {
        isFound = true;
        const Mask both =
          lattice.Close(own | lattice.Faces[other - this->Pieces.GetFirstPlace(cell)]);
        if (both != own)
        {
          this->Influences[face].push_back(Masks * cell + both);
        }
      }
    }
  }
  if (!isFound)
  {
    this->IsOpen[face] = 1;
  }
}

/// The corners of a cell that are those of a face of another one.
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

/// From the cell on over rows of faces that have the given one.
Sectors::Sector Sectors::FindSector(vtkIdType cell, Mask face) const
{
  Sector sector;
  std::vector<vtkIdType> found;
  const auto has = [&found](vtkIdType number)
  { return std::find(found.begin(), found.end(), number) != found.end(); };
  const auto add = [&](vtkIdType other, Mask whole)
  {
    if (has(this->GetFace(other, whole)))
    {
      return; // with all its faces
    }
    const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(other);
    sector.HasTets =
      sector.HasTets || (this->Pieces.GetDimension(other) == 3 && whole == lattice.GetWhole());
    ForFaces(lattice, whole, this->FindCorners(other, cell, face),
      [&](Mask mask)
      {
        const vtkIdType number = this->GetFace(other, mask);
        if (!has(number))
        {
          found.push_back(number);
        }
      });
  };
  add(cell, this->Pieces.GetLattice(cell).GetWhole());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    sector.IsOpen = sector.IsOpen || this->IsOpen[found[i]];
    for (const vtkIdType influence : this->Influences[found[i]])
    {
      add(influence / Masks, static_cast<Mask>(influence % Masks));
    }
  }
  sector.Faces = std::move(found);
  std::sort(sector.Faces.begin(), sector.Faces.end());
  return sector;
}

}
