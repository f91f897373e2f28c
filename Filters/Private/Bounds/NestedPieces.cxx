// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/NestedPieces.h"

#include "Core/Memory/Sorting.h"
#include "Private/Bounds/TetOctPieces.h"
#include "Private/Bounds/TetOctReader.h"
#include "Private/Reading/CellReader.h"
#include "Private/Roots/SplitRoots.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace subdivision
{

NestedPieces::NestedPieces(
  vtkPointSet* fine, const std::array<vtkIdType, Steps + 1>& points, vtkPointSet* before)
  : NestedPieces({}, {}, points)
{
  const SplitRoots roots(fine, Steps);
  this->ReadCells(roots, before);
  this->PlacePoints = Buffer<vtkIdType>(this->FirstPlaces.back());
  this->ReadPlaces(roots);
  if (before)
  {
    this->ReadTetOct(roots, fine, before);
    this->AlignEqualTets();
  }
  this->FindParents();
}

NestedPieces::NestedPieces(const std::vector<int>& kinds, Buffer<vtkIdType> placePoints,
  const std::array<vtkIdType, Steps + 1>& points)
  : Points(points)
  , PlacePoints(std::move(placePoints))
{
  for (int kind = -1; kind < Lattice::NumberOfKinds; ++kind)
  {
    this->Lattices[kind + 1] = &Lattice::Get(kind);
  }
  for (const int kind : InTurn(kinds))
  {
    this->AddCell(kind);
  }
  this->FindParents();
}

void NestedPieces::AddCell(int kind)
{
  this->Kinds.push_back(static_cast<signed char>(kind));
  this->FirstPlaces.push_back(this->FirstPlaces.back() + this->Lattices[kind + 1]->CountPoints());
  if (kind >= 0)
  {
    this->Has[kind] = true;
  }
}

void NestedPieces::ReadCells(const SplitRoots& roots, vtkPointSet* before)
{
  std::vector<int> kinds;
  bool isNested = !before || before->GetNumberOfCells() == roots.GetNumberOfRoots();
  for (const vtkIdType r : InTurn(isNested ? roots.GetNumberOfRoots() : 0))
  {
    const Root& root = roots.GetRoot(r);
    isNested = isNested && root.Lattice && root.Steps == Steps &&
      (root.Shape <= CellShape::Tet || (before && root.Shape == CellShape::Octahedron));
    kinds.push_back(root.Shape == CellShape::Octahedron ? Lattice::FirstQuarter + root.Quarter
        : before && root.Shape == CellShape::Tet        ? Lattice::TetOctTetrahedron
                                                        : static_cast<int>(root.Shape) - 1);
  }
  for (const std::size_t c : InTurn(isNested ? kinds.size() : 0))
  {
    this->AddCell(kinds[c]);
  }
}

bool NestedPieces::AreOf(vtkPointSet* mesh) const
{
  const CellReader cells(mesh);
  if (cells.GetNumberOfCells() != this->GetNumberOfCells())
  {
    return false;
  }
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    std::array<vtkIdType, MostCorners> corners{};
    for (int k = 0; k < this->GetNumberOfCorners(c); ++k)
    {
      corners[k] = this->GetCorner(c, k);
    }
    const bool isAnyOrder = this->Kinds[c] == Lattice::TetOctTetrahedron; // see AlignEqualTets
    if (cell.Size != this->GetNumberOfCorners(c) ||
      !(isAnyOrder ? std::is_permutation(cell.Ids, cell.Ids + cell.Size, corners.begin())
                   : std::equal(cell.Ids, cell.Ids + cell.Size, corners.begin())))
    {
      return false;
    }
  }
  return true;
}

void NestedPieces::ReadPlaces(const SplitRoots& roots)
{
  ForEach(this->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      vtkIdType* to = this->PlacePoints.data() + this->FirstPlaces[c];
      const Root& root = roots.GetRoot(c);
      if (this->Kinds[c] < PatchShape::NumberOfKinds)
      {
        const auto& places = this->GetLattice(c).Places;
        std::transform(places.begin(), places.end(), to,
          [&](const FrameNode& place) { return roots.GetPoint(root, place); });
      }
    });
}

void NestedPieces::ReadTetOct(const SplitRoots& roots, vtkPointSet* fine, vtkPointSet* before)
{
  const CellReader cells(before);
  const TetOctReader reader(fine);
  ForRanges(this->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> scratch;
      for (vtkIdType c = begin; c < end; ++c)
      {
        const int quarter = this->Kinds[c] - Lattice::FirstQuarter;
        if (this->Kinds[c] < PatchShape::NumberOfKinds || quarter > 0)
        {
          continue; // with the first quarter
        }
        TetOctReader::Solid solid = reader.GetTet(roots.GetRoot(c).First);
        if (quarter == 0)
        {
          std::array<vtkIdType, 16> corners{};
          for (int k = 0; k < 4; ++k)
          {
            const CellIds cell = cells.GetCell(c + k, scratch);
            std::copy_n(cell.Ids, 4, corners.data() + 4 * k);
          }
          solid = reader.GetOct(solid.First, TetOctPieces::Join(corners.data()));
        }
        for (vtkIdType part = c; part < (quarter < 0 ? c + 1 : c + 4); ++part)
        {
          vtkIdType* to = this->PlacePoints.data() + this->FirstPlaces[part];
          const Lattice& lattice = this->GetLattice(part);
          for (int point = 0; point < lattice.CountPoints(); ++point)
          {
            *to++ = reader.GetPoint(solid, lattice.GetPlaceInSolid(point));
          }
        }
      }
    });
}

/// Equal tetrahedra have the same points, and so have the octahedra in them. These must be cut
/// around the same diagonal, which follows from the order of the corners: it becomes the order of
/// the first.
void NestedPieces::AlignEqualTets()
{
  using Corners = std::array<vtkIdType, MostCorners>;
  const Lattice& lattice = Lattice::Get(Lattice::TetOctTetrahedron);
  std::vector<std::pair<Corners, vtkIdType>> tets;
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    if (this->Kinds[c] == Lattice::TetOctTetrahedron)
    {
      Corners corners{};
      for (int k = 0; k < MostCorners; ++k)
      {
        corners[k] = this->GetCorner(c, k);
      }
      std::sort(corners.begin(), corners.end());
      tets.emplace_back(corners, c);
    }
  }
  StableSort(tets, std::less<>());
  for (std::size_t i = 1; i < tets.size(); ++i)
  {
    if (tets[i].first == tets[i - 1].first)
    {
      std::copy_n(this->PlacePoints.data() + this->FirstPlaces[tets[i - 1].second],
        lattice.Places.size(), this->PlacePoints.data() + this->FirstPlaces[tets[i].second]);
    }
  }
}

/// All cells that have a new point find the same parents.
void NestedPieces::FindParents()
{
  for (const int step : { 2, 3 })
  {
    const vtkIdType before = this->Points[step - 1];
    this->Parents[step] = Buffer<vtkIdType>(MostCorners * (this->Points[step] - before), -1);
    for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
    {
      const vtkIdType first = this->FirstPlaces[c];
      for (const Lattice::Middle& middle : this->GetLattice(c).Middles[step])
      {
        vtkIdType* parents = this->Parents[step].data() +
          MostCorners * (this->GetPoint(first + middle.Point) - before);
        if (parents[0] < 0)
        {
          vtkIdType* end = parents;
          for (int k = 0; k < MostCorners && middle.Parents[k] >= 0; ++k)
          {
            *end++ = this->GetPoint(first + middle.Parents[k]);
          }
          std::sort(parents, end);
        }
      }
    }
  }
}

}
