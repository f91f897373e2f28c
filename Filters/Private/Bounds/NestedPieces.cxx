// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/NestedPieces.h"

#include "Core/Memory/Sorting.h"
#include "Private/Bezier/BezierRoots.h"
#include "Private/Bounds/TetOctReader.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace subdivision
{

NestedPieces::NestedPieces(
  vtkPointSet* fine, const std::array<vtkIdType, Steps + 1>& points, const TetOctMesh* before)
  : Points(points)
{
  this->FindLattices();
  const BezierRoots roots(fine, Steps);
  this->ReadCells(roots, before);
  if (this->IsNested)
  {
    this->CountPlaces();
    this->ReadPlaces(roots);
    if (before)
    {
      this->ReadTetOct(roots, fine, before->Mesh);
      this->AlignEqualTets();
    }
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
  this->FindLattices();
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

void NestedPieces::FindLattices()
{
  for (int kind = -1; kind < Lattice::NumberOfKinds; ++kind)
  {
    this->Lattices[kind + 1] = &Lattice::Get(kind);
  }
}

void NestedPieces::ReadCells(const BezierRoots& roots, const TetOctMesh* before)
{
  this->IsNested = !before || before->Mesh->GetNumberOfCells() == roots.GetNumberOfRoots();
  for (const vtkIdType r : InTurn(roots.GetNumberOfRoots()))
  {
    const Root& root = roots.GetRoot(r);
    this->IsNested =
      this->IsNested && (root.Kind < 0 ? roots.GetType(root) == VTK_VERTEX : root.Steps == Steps);
    if (!this->IsNested)
    {
      return;
    }
    const int kind =
      before && root.Kind == PatchShape::Tetrahedron ? this->FindTetOctKind(*before, r) : root.Kind;
    this->Kinds.push_back(static_cast<signed char>(kind));
    if (kind >= 0)
    {
      this->Has[kind] = true;
    }
  }
}

/// The quarters of an octahedron follow each other.
int NestedPieces::FindTetOctKind(const TetOctMesh& before, vtkIdType cell) const
{
  if (!before.Octahedra || before.Octahedra->GetComponent(cell, 0) < 0.)
  {
    return Lattice::TetOctTetrahedron;
  }
  const int last = cell > 0 ? this->Kinds[cell - 1] : -1;
  const bool isFirst = last < Lattice::FirstQuarter || last == Lattice::NumberOfKinds - 1;
  return isFirst ? Lattice::FirstQuarter : last + 1;
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
    const vtkIdType* corners = this->CellCorners.data() + MostCorners * c;
    const bool isAnyOrder = this->Kinds[c] == Lattice::TetOctTetrahedron; // see AlignEqualTets
    if (cell.Size != this->GetNumberOfCorners(c) ||
      !(isAnyOrder ? std::is_permutation(cell.Ids, cell.Ids + cell.Size, corners)
                   : std::equal(cell.Ids, cell.Ids + cell.Size, corners)))
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
      if (this->Kinds[c] < PatchShape::NumberOfKinds)
      {
        for (const LatticePoint& place : this->GetLattice(c).Places)
        {
          *to++ = roots.GetPoint(root, place);
        }
      }
    });
}

void NestedPieces::ReadTetOct(const BezierRoots& roots, vtkPointSet* fine, vtkPointSet* before)
{
  const CellReader cells(before);
  ForRanges(this->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      TetOctReader reader(fine);
      std::vector<vtkIdType> scratch;
      for (vtkIdType c = begin; c < end; ++c)
      {
        const int quarter = this->Kinds[c] - Lattice::FirstQuarter;
        if (this->Kinds[c] < PatchShape::NumberOfKinds || quarter > 0)
        {
          continue; // with the first quarter
        }
        if (quarter < 0)
        {
          reader.ReadTet(roots.GetRoot(c).First);
        }
        else
        {
          std::array<vtkIdType, 16> corners{};
          for (int k = 0; k < 4; ++k)
          {
            const CellIds cell = cells.GetCell(c + k, scratch);
            std::copy_n(cell.Ids, 4, corners.data() + 4 * k);
          }
          reader.ReadOct(roots.GetRoot(c).First, TetOctPieces::Join(corners.data()));
        }
        for (vtkIdType part = c; part < (quarter < 0 ? c + 1 : c + 4); ++part)
        {
          vtkIdType* to = this->PlacePoints.data() + this->FirstPlaces[part];
          const Lattice& lattice = this->GetLattice(part);
          for (int point = 0; point < static_cast<int>(lattice.Places.size()); ++point)
          {
            *to++ = reader.Get(lattice.GetPlaceInSolid(point));
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
        corners[k] = this->GetPoint(this->FirstPlaces[c] + lattice.GetCornerPoint(k));
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
