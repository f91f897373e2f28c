// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/PartsAsCells.h"

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
#include <array>
#include <set>
#include <utility>

namespace subdivision
{
namespace
{

using Part = PartsAsCells::Part;

/// The row of a point in the last two steps.
Sectors::Entries GetLastRow(const SteppedPieces& from, vtkIdType point)
{
  return GetRow(from.Last, point, [](vtkIdType column) { return column; });
}

class PartsInThirds : public PartsAsCells
{
public:
  /// The limit depends on two layers of triangles of the last step, which lie in one layer of
  /// parts, and so do the rings there.
  PartsInThirds(const SteppedPieces& from, const std::vector<Part>& wanted)
    : PartsAsCells(from)
  {
    this->ListParts(wanted);
  }
  /// Returns false where `subdivide` returns null.
  bool Split(const SubdividePatch& subdivide)
  {
    const auto patch = this->CutOut();
    this->Pieces = ReadThirds(
      [&](int steps) { return subdivide(patch, steps, steps == 4 ? &this->Factors : nullptr); });
    if (this->Pieces)
    {
      this->Finish(this->Cells, ListFactors(this->Factors, 2, 4));
    }
    return this->Pieces != nullptr;
  }

private:
  using Ends = std::array<vtkIdType, 2>;
  int GetDimension(const Part& part) const { return this->From.Pieces.GetDimension(part.Cell); }
  /// Edges of triangles that are cut by points of which the nearer end is more than half, with one
  /// other point or two (a row of any other such point has the ends and both neighbours, or, around
  /// a vertex of two triangles, equal weights). The fixed weights are read off the rows.
  std::set<Ends> ListFixedEdges() const
  {
    std::set<Ends> fixed;
    for (const Part& part : InTurn(this->Parts))
    {
      for (const PieceLattice::Middle& middle : this->GetLattice(part).Middles[2])
      {
        const auto& parents = middle.Parents; // of an edge: one of its ends is there twice
        if (this->GetDimension(part) < 2 || (parents[0] != parents[1] && parents[1] != parents[2]))
        {
          continue;
        }
        const auto row = GetLastRow(this->From, this->GetOld(part, middle.Point));
        const bool isCurve = row.size() <= 3 &&
          std::any_of(row.begin(), row.end(), [](const auto& entry) { return entry.second > 0.5; });
        if (isCurve)
        {
          Ends ends{ { this->GetOld(part, parents[0]), this->GetOld(part, parents[2]) } };
          std::sort(ends.begin(), ends.end());
          fixed.insert(ends);
        }
      }
    }
    return fixed;
  }
  /// Makes the parts a mesh, with a line on each fixed edge, and a vertex at each point that stays.
  vtkSmartPointer<vtkPolyData> CutOut()
  {
    std::vector<vtkIdType> old;
    for (const Part& part : InTurn(this->Parts))
    {
      for (int k = 0; k < this->GetLattice(part).Corners; ++k)
      {
        old.push_back(this->GetOldCorner(part, k));
      }
    }
    SortDistinct(old);
    const vtkNew<vtkPoints> points;
    const vtkNew<vtkCellArray> cells[3]; // by dimension
    for (const vtkIdType point : InTurn(old))
    {
      const vtkIdType number =
        points->InsertNextPoint(static_cast<double>(point), 0., 0.); // not used
      if (GetLastRow(this->From, point).size() == 1)
      {
        cells[0]->InsertNextCell(1, &number);
      }
    }
    const auto insert = [&](int dimension, const auto& getCorner)
    {
      vtkIdType corners[3]{};
      for (int k = 0; k <= dimension; ++k)
      {
        corners[k] = std::lower_bound(old.begin(), old.end(), getCorner(k)) - old.begin();
      }
      return cells[dimension]->InsertNextCell(dimension + 1, corners);
    };
    for (const Part& part : InTurn(this->Parts))
    {
      this->Cells.push_back(
        insert(this->GetDimension(part), [&](int k) { return this->GetOldCorner(part, k); }));
    }
    for (const Ends& ends : this->ListFixedEdges())
    {
      insert(1, [&](int k) { return ends[k]; });
    }
    const vtkIdType firstLine = cells[0]->GetNumberOfCells();
    const vtkIdType firstTriangle = firstLine + cells[1]->GetNumberOfCells();
    for (const std::size_t p : InTurn(this->Parts.size()))
    {
      const int dimension = this->GetDimension(this->Parts[p]);
      this->Cells[p] += dimension == 2 ? firstTriangle : firstLine;
    }
    auto patch = vtkSmartPointer<vtkPolyData>::New();
    patch->SetPoints(points);
    patch->SetVerts(cells[0]);
    patch->SetLines(cells[1]);
    patch->SetPolys(cells[2]);
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

  std::vector<vtkIdType> Cells; ///< of the parts, in the patch
  MatrixFactors Factors;
};

}

std::unique_ptr<PartsAsCells> SplitIntoThirds(
  const SteppedPieces& from, const std::vector<Part>& wanted, const SubdividePatch& subdivide)
{
  auto made = std::make_unique<PartsInThirds>(from, wanted);
  return made->Split(subdivide) ? std::move(made) : nullptr;
}

}
