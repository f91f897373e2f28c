// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/NestedPieces.h"

#include "Private/Bezier/BezierRoots.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellType.h"

#include <algorithm>
#include <utility>

namespace subdivision
{

NestedPieces::NestedPieces(vtkPointSet* fine, const std::array<vtkIdType, Steps + 1>& points)
  : Points(points)
{
  const BezierRoots roots(fine, Steps);
  this->ReadCells(roots);
  if (this->IsNested)
  {
    this->CountPlaces();
    this->ReadPlaces(roots);
    this->FindCorners();
    this->FindParents(2);
    this->FindParents(3);
  }
}

NestedPieces::NestedPieces(std::vector<signed char> kinds, Buffer<vtkIdType> placePoints,
  const std::array<vtkIdType, Steps + 1>& points)
  : Points(points)
  , Kinds(std::move(kinds))
  , PlacePoints(std::move(placePoints))
{
  for (const signed char kind : InTurn(this->Kinds))
  {
    if (kind >= 0)
    {
      this->Has[kind] = true;
    }
  }
  this->CountPlaces();
  this->FindCorners();
  this->FindParents(2);
  this->FindParents(3);
}

void NestedPieces::ReadCells(const BezierRoots& roots)
{
  for (const vtkIdType r : InTurn(roots.GetNumberOfRoots()))
  {
    const Root& root = roots.GetRoot(r);
    this->IsNested =
      this->IsNested && (root.Kind < 0 ? roots.GetType(root) == VTK_VERTEX : root.Steps == Steps);
    if (!this->IsNested)
    {
      return;
    }
    this->Kinds.push_back(static_cast<signed char>(root.Kind));
    if (root.Kind >= 0)
    {
      this->Has[root.Kind] = true;
    }
  }
}

bool NestedPieces::AreOf(vtkPointSet* mesh) const
{
  const CellReader cells(mesh);
  if (!this->IsNested || cells.GetNumberOfCells() != this->GetNumberOfCells())
  {
    return false;
  }
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    if (cell.Size != this->GetNumberOfCorners(c) ||
      !std::equal(cell.Ids, cell.Ids + cell.Size, this->CellCorners.data() + MostCorners * c))
    {
      return false;
    }
  }
  return true;
}

void NestedPieces::CountPlaces()
{
  this->FirstPlaces.push_back(0);
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    this->FirstPlaces.push_back(
      this->FirstPlaces.back() + static_cast<vtkIdType>(this->GetLattice(c).Points.size()));
  }
}

void NestedPieces::ReadPlaces(const BezierRoots& roots)
{
  this->PlacePoints = Buffer<vtkIdType>(this->FirstPlaces.back());
  ForEach(this->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      thread_local std::vector<vtkIdType> ids;
      vtkIdType* to = this->PlacePoints.data() + this->FirstPlaces[c];
      const Root& root = roots.GetRoot(c);
      if (root.Kind < 0)
      {
        roots.GetPoints(root, ids);
        *to = ids[0];
        return;
      }
      for (const LatticePoint& place : this->GetLattice(c).Places)
      {
        *to++ = roots.GetPoint(root, place);
      }
    });
}

void NestedPieces::FindCorners()
{
  this->CellCorners = Buffer<vtkIdType>(MostCorners * this->GetNumberOfCells(), -1);
  ForEach(this->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      const Lattice& lattice = this->GetLattice(c);
      for (int k = 0; k < lattice.Corners; ++k)
      {
        this->CellCorners[MostCorners * c + k] =
          this->GetPoint(this->FirstPlaces[c] + lattice.GetCornerPoint(k));
      }
    });
}

/// All cells that have a new point find the same parents.
void NestedPieces::FindParents(int step)
{
  const vtkIdType before = this->Points[step - 1];
  this->Parents[step] = Buffer<vtkIdType>(MostCorners * (this->Points[step] - before), -1);
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    const vtkIdType first = this->FirstPlaces[c];
    for (const Lattice::Middle& middle : this->GetLattice(c).Middles[step])
    {
      vtkIdType* parents =
        this->Parents[step].data() + MostCorners * (this->GetPoint(first + middle.Point) - before);
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
