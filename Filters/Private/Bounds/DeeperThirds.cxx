// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/DeeperThirds.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Private/Bounds/StepFactors.h"
#include "Private/Bounds/ThirdsReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <cstddef>

namespace subdivision
{
namespace
{

constexpr int Divisions = PieceLattice::DivisionsInThirds;

}

std::unique_ptr<DeeperThirds> DeeperThirds::Make(
  const SteppedPieces& from, const std::vector<Part>& wanted, const SubdividePatch& subdivide)
{
  std::unique_ptr<DeeperThirds> made(new DeeperThirds(from));
  made->ListParts(wanted);
  if (!made->Split(made->CutOut(), subdivide))
  {
    return nullptr;
  }
  made->Wanted.assign(
    made->Cells.begin(), made->Cells.begin() + static_cast<std::ptrdiff_t>(wanted.size()));
  made->FindOld();
  return made;
}

/// The limit depends on two layers of triangles of the last step, which lie in one layer of parts,
/// and so do the rings there.
void DeeperThirds::ListParts(const std::vector<Part>& wanted)
{
  std::vector<vtkIdType> corners;
  for (const Part& part : InTurn(wanted))
  {
    this->AddPart(part);
    const std::vector<vtkIdType> its = this->GetCornersOf(part);
    corners.insert(corners.end(), its.begin(), its.end());
  }
  SortDistinct(corners);
  for (const vtkIdType corner : InTurn(corners))
  {
    this->AddPartsAt(corner);
  }
}

void DeeperThirds::AddPart(const Part& part)
{
  if (this->Known.insert(part).second)
  {
    this->Parts.push_back(part);
  }
}

/// Adds all parts that have a point as a corner.
void DeeperThirds::AddPartsAt(vtkIdType point)
{
  for (const vtkIdType place : this->From.AllSectors.GetPlaces(point))
  {
    Part part{ this->From.AllSectors.GetCell(place), 0 };
    const PieceLattice& lattice = this->From.Pieces.GetLattice(part.Cell);
    const LatticePoint& at = lattice.Places[place - this->From.Pieces.GetFirstPlace(part.Cell)];
    const auto children = static_cast<int>(lattice.Children.size());
    for (; lattice.Dimension > 0 && part.Child < children; ++part.Child)
    {
      for (int k = 0; k < lattice.Corners; ++k)
      {
        if (lattice.Children[part.Child].At(lattice.CornerPlaces[k], 1) == at)
        {
          this->AddPart(part);
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

/// The row of a point in the last two steps.
std::vector<std::pair<vtkIdType, double>> DeeperThirds::GetRow(vtkIdType point) const
{
  std::vector<std::pair<vtkIdType, double>> row;
  ForColumns(this->From.Last, this->From.Last.size(), point, 1.,
    [&](vtkIdType column, double weight)
    {
      const auto at = std::find_if(
        row.begin(), row.end(), [column](const auto& entry) { return entry.first == column; });
      if (at == row.end())
      {
        row.emplace_back(column, weight);
        return;
      }
      at->second += weight;
    });
  return row;
}

/// Edges of triangles that are cut by points of which the nearer end is more than half, with one
/// other point or two (a row of any other such point has the ends and both neighbours, or, around a
/// vertex of two triangles, equal weights).
std::set<DeeperThirds::Ends> DeeperThirds::ListFixedEdges() const
{
  std::set<Ends> fixed;
  for (const Part& part : InTurn(this->Parts))
  {
    const PieceLattice& lattice = this->From.Pieces.GetLattice(part.Cell);
    for (const PieceLattice::Middle& middle : lattice.Middles[2])
    {
      const auto& parents = middle.Parents;
      if (this->IsLine(part) || parents[0] != parents[1])
      {
        continue;
      }
      const auto row = this->GetRow(this->GetPoint(part, lattice.Places[middle.Point]));
      const bool isCurve = row.size() <= 3 &&
        std::any_of(row.begin(), row.end(), [](const auto& entry) { return entry.second > 0.5; });
      if (isCurve)
      {
        Ends ends{ { this->GetPoint(part, lattice.Places[parents[0]]),
          this->GetPoint(part, lattice.Places[parents[2]]) } };
        std::sort(ends.begin(), ends.end());
        fixed.insert(ends);
      }
    }
  }
  return fixed;
}

/// Makes the parts a mesh, with a line on each fixed edge, and a vertex at each point that stays.
vtkSmartPointer<vtkPolyData> DeeperThirds::CutOut()
{
  for (const Part& part : InTurn(this->Parts))
  {
    const std::vector<vtkIdType> corners = this->GetCornersOf(part);
    this->Old.insert(this->Old.end(), corners.begin(), corners.end());
  }
  SortDistinct(this->Old);
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> vertices;
  const vtkNew<vtkCellArray> lines;
  const vtkNew<vtkCellArray> triangles;
  for (const vtkIdType old : InTurn(this->Old))
  {
    const vtkIdType number = points->InsertNextPoint(static_cast<double>(old), 0., 0.); // not used
    if (this->GetRow(old).size() == 1)
    {
      vertices->InsertNextCell(1, &number);
    }
  }
  const auto insert = [this](vtkCellArray* cells, std::vector<vtkIdType> corners)
  {
    std::transform(corners.begin(), corners.end(), corners.begin(), [this](vtkIdType old)
      { return std::lower_bound(this->Old.begin(), this->Old.end(), old) - this->Old.begin(); });
    return cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  };
  for (const Part& part : InTurn(this->Parts))
  {
    vtkCellArray* cells = this->IsLine(part) ? lines : triangles;
    this->Cells.push_back(insert(cells, this->GetCornersOf(part)));
  }
  for (const Ends& ends : this->ListFixedEdges())
  {
    insert(lines, { ends[0], ends[1] });
  }
  const vtkIdType firstLine = vertices->GetNumberOfCells();
  const vtkIdType firstTriangle = firstLine + lines->GetNumberOfCells();
  for (const std::size_t p : InTurn(this->Parts.size()))
  {
    this->Cells[p] += this->IsLine(this->Parts[p]) ? firstLine : firstTriangle;
  }
  auto patch = vtkSmartPointer<vtkPolyData>::New();
  patch->SetPoints(points);
  patch->SetVerts(vertices);
  patch->SetLines(lines);
  patch->SetPolys(triangles);
  const vtkNew<vtkSignedCharArray> singular;
  singular->SetName(PatchSingularName);
  singular->SetNumberOfValues(patch->GetNumberOfCells());
  for (const vtkIdType c : InTurn(patch->GetNumberOfCells()))
  {
    singular->SetValue(c, c < firstTriangle ? 1 : 0);
  }
  patch->GetCellData()->AddArray(singular);
  return patch;
}

bool DeeperThirds::Split(vtkPolyData* patch, const SubdividePatch& subdivide)
{
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
  this->Last = ListFactors(this->Factors, 2, 4);
  this->AllSectors = std::make_unique<Sectors>(*this->Pieces, this->Last);
  return true;
}

/// Finds which points before the points of the patch are, and where its corners were.
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
