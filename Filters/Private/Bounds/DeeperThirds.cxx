// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/DeeperThirds.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Bounds/ThirdsReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <array>
#include <set>

namespace subdivision
{
namespace
{

constexpr int Divisions = PieceLattice::DivisionsInThirds;

}

/// The limit depends on two layers of triangles of the last step, which lie in one layer of parts,
/// and so do the rings there.
DeeperThirds::DeeperThirds(const SteppedPieces& from, const std::vector<Part>& wanted)
  : From(from)
{
  for (const Part& part : InTurn(wanted))
  {
    this->AddPart(part);
  }
  this->CountOfWanted = this->Parts.size();
  for (const Part& part : InTurn(wanted))
  {
    this->AddNeighbours(part);
  }
}

void DeeperThirds::AddPart(const Part& part)
{
  if (this->Numbers.try_emplace(part, this->Parts.size()).second)
  {
    this->Parts.push_back(part);
  }
}

/// Adds all parts that have a corner with a part in common.
void DeeperThirds::AddNeighbours(const Part& part)
{
  for (const vtkIdType corner : this->GetCornersOf(part))
  {
    for (const vtkIdType place : this->From.AllSectors.GetPlaces(corner))
    {
      Part other{ this->From.AllSectors.GetCell(place), 0 };
      const bool isVertex = this->From.Pieces.GetDimension(other.Cell) == 0;
      const auto children = this->From.Pieces.GetLattice(other.Cell).Children.size();
      for (; !isVertex && other.Child < static_cast<int>(children); ++other.Child)
      {
        const std::vector<vtkIdType> corners = this->GetCornersOf(other);
        if (std::find(corners.begin(), corners.end(), corner) != corners.end())
        {
          this->AddPart(other);
        }
      }
    }
  }
}

/// A point of the cells before, by its place in a part.
vtkIdType DeeperThirds::GetPoint(const Part& part, const LatticePoint& place) const
{
  const PieceLattice& lattice = this->From.Pieces.GetLattice(part.Cell);
  return this->From.Pieces.GetPoint(this->From.Pieces.GetFirstPlace(part.Cell) +
    lattice.Find(lattice.Children[part.Child].At(place, Divisions)));
}

std::vector<vtkIdType> DeeperThirds::GetCornersOf(const Part& part) const
{
  const PieceLattice& lattice = this->From.Pieces.GetLattice(part.Cell);
  std::vector<vtkIdType> corners;
  for (int k = 0; k < lattice.Corners; ++k)
  {
    corners.push_back(this->GetPoint(part, lattice.Places[lattice.GetCornerPoint(k)]));
  }
  return corners;
}

/// How many points the row of a point in the last two steps has.
std::size_t DeeperThirds::CountColumns(vtkIdType point) const
{
  std::vector<vtkIdType> columns;
  ForColumns(this->From.Last, this->From.Last.size(), point, 1.,
    [&](vtkIdType column, double) { columns.push_back(column); });
  SortDistinct(columns);
  return columns.size();
}

/// Makes the parts a mesh, with a line on each fixed edge and a vertex at each corner of curves.
/// Only these stay as they are; and only the points that cut a fixed edge have rows of at most
/// three points.
vtkSmartPointer<vtkPolyData> DeeperThirds::CutOut()
{
  using Ends = std::array<vtkIdType, 2>;
  std::set<Ends> fixed;
  for (const Part& part : InTurn(this->Parts))
  {
    const std::vector<vtkIdType> corners = this->GetCornersOf(part);
    this->Old.insert(this->Old.end(), corners.begin(), corners.end());
    const PieceLattice& lattice = this->From.Pieces.GetLattice(part.Cell);
    for (const PieceLattice::Middle& middle : lattice.Middles[2])
    {
      const auto& parents = middle.Parents;
      const bool isOnEdge = parents[0] == parents[1];
      if (lattice.Dimension == 2 && isOnEdge &&
        this->CountColumns(this->GetPoint(part, lattice.Places[middle.Point])) <= 3)
      {
        Ends ends{ { this->GetPoint(part, lattice.Places[parents[0]]),
          this->GetPoint(part, lattice.Places[parents[2]]) } };
        std::sort(ends.begin(), ends.end());
        fixed.insert(ends);
      }
    }
  }
  SortDistinct(this->Old);
  const auto getNumber = [this](vtkIdType old)
  {
    return static_cast<vtkIdType>(
      std::lower_bound(this->Old.begin(), this->Old.end(), old) - this->Old.begin());
  };
  const auto patch = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> vertices;
  const vtkNew<vtkCellArray> lines;
  const vtkNew<vtkCellArray> triangles;
  for (const vtkIdType old : InTurn(this->Old))
  {
    const vtkIdType number = points->InsertNextPoint(static_cast<double>(old), 0., 0.); // not used
    if (this->CountColumns(old) == 1)
    {
      vertices->InsertNextCell(1, &number);
    }
  }
  const auto insert = [&](vtkCellArray* cells, std::vector<vtkIdType> corners)
  {
    std::transform(corners.begin(), corners.end(), corners.begin(), getNumber);
    return cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  };
  for (const Part& part : InTurn(this->Parts))
  {
    const bool isLine = this->From.Pieces.GetDimension(part.Cell) == 1;
    this->Cells.push_back(insert(isLine ? lines.Get() : triangles.Get(), this->GetCornersOf(part)));
  }
  for (const Ends& ends : fixed)
  {
    insert(lines, { ends[0], ends[1] });
  }
  for (const std::size_t p : InTurn(this->Parts.size()))
  {
    const bool isLine = this->From.Pieces.GetDimension(this->Parts[p].Cell) == 1;
    this->Cells[p] += vertices->GetNumberOfCells() + (isLine ? 0 : lines->GetNumberOfCells());
  }
  patch->SetPoints(points);
  patch->SetVerts(vertices);
  patch->SetLines(lines);
  patch->SetPolys(triangles);
  const vtkNew<vtkSignedCharArray> singular;
  singular->SetName(PatchSingularName);
  singular->SetNumberOfValues(patch->GetNumberOfCells());
  for (const vtkIdType c : InTurn(patch->GetNumberOfCells()))
  {
    singular->SetValue(c, c < vertices->GetNumberOfCells() + lines->GetNumberOfCells() ? 1 : 0);
  }
  patch->GetCellData()->AddArray(singular);
  return patch;
}

bool DeeperThirds::Run(const SubdividePatch& subdivide)
{
  const vtkSmartPointer<vtkPolyData> patch = this->CutOut();
  FourSqrtThreeSteps meshes;
  for (std::size_t step = 0; step < meshes.size(); ++step)
  {
    meshes[step] = subdivide(
      patch, static_cast<int>(step), step + 1 == meshes.size() ? &this->Factors : nullptr);
    if (!meshes[step])
    {
      return false;
    }
  }
  this->Pieces = std::make_unique<NestedPieces>(ReadThirds(meshes));
  for (std::size_t f = this->Factors.GetOperations()[2].Begin; f < this->Factors.Get().size(); ++f)
  {
    this->Last.push_back(&this->Factors.Get()[f]);
  }
  this->AllSectors = std::make_unique<Sectors>(*this->Pieces, this->Last);
  this->Wanted.assign(
    this->Cells.begin(), this->Cells.begin() + static_cast<std::ptrdiff_t>(this->CountOfWanted));
  this->FindOld();
  return true;
}

/// Which points before those of the patch are, and where its corners were.
void DeeperThirds::FindOld()
{
  this->Corners.resize(this->Old.size(), { -1, -1 });
  this->Old.resize(static_cast<std::size_t>(this->Pieces->GetNumberOfPoints(2)), -1);
  for (const std::size_t p : InTurn(this->Parts.size()))
  {
    const Part& part = this->Parts[p];
    const PieceLattice& lattice = this->From.Pieces.GetLattice(part.Cell);
    const vtkIdType first = this->Pieces->GetFirstPlace(this->Cells[p]);
    for (std::size_t i = 0; i < lattice.Places.size(); ++i)
    {
      const LatticePoint& place = lattice.Places[i];
      const vtkIdType point = this->Pieces->GetPoint(first + static_cast<vtkIdType>(i));
      if (point < this->Pieces->GetNumberOfPoints(2))
      {
        this->Old[point] = this->GetPoint(part, place);
      }
      if (point < this->Pieces->GetNumberOfPoints(1))
      {
        this->Corners[point] = { part.Cell,
          lattice.Find(lattice.Children[part.Child].At(place, Divisions)) };
      }
    }
  }
}

}
