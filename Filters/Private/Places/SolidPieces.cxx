// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/SolidPieces.h"

#include "Core/Solids/Limits/PlacePolynomial.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>

namespace subdivision
{

std::array<double, 4> LeavePartOfSimplex(
  int dimension, int levels, vtkIdType part, std::array<double, 4> weights)
{
  const auto& children = ListChildren(dimension);
  for (int step = 0; dimension > 0 && step < levels; ++step)
  {
    const auto count = static_cast<vtkIdType>(children.size());
    const auto& corners = children[static_cast<std::size_t>(part % count)].Corners;
    part /= count;
    std::array<double, 4> of{};
    for (int i = 0; i <= dimension; ++i)
    {
      for (const int corner : corners[i])
      {
        of[corner] += 0.5 * weights[i];
      }
    }
    weights = of;
  }
  return weights;
}

SolidPieces::SolidPieces(const SearchedCells& cells, vtkDataSet* fine, int levels)
  : Levels(levels)
  , Firsts(cells.GetNumberOfCells() + 1)
  , Points(3 * fine->GetNumberOfPoints())
{
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c) { this->Firsts[c] = vtkIdType(1) << (levels * cells.Dimensions[c]); });
  CountsToOffsets(this->Firsts);
  ForEachInTurn(fine->GetNumberOfPoints(),
    [&](vtkIdType i) { fine->GetPoint(i, this->Points.data() + 3 * i); });
  std::vector<int> corners;
  vtkNew<vtkIdList> ids;
  ForEachInTurn(fine->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      if (fine->GetCellType(c) == VTK_TETRA)
      {
        fine->GetCellPoints(c, ids);
        for (vtkIdType k = 0; k < 4; ++k)
        {
          corners.push_back(static_cast<int>(ids->GetId(k)));
          this->All.Add(this->Points.data() + 3 * ids->GetId(k));
        }
        this->Numbers.push_back(c);
      }
    });
  this->Corners = Buffer<int>(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), this->Corners.begin());
  if (!this->Numbers.empty())
  {
    this->Tree = SimplexTree(this->Points.data(), 4, this->Corners);
  }
}

bool SolidPieces::Find(const std::array<double, 3>& x, bool isBeside, NearestPlace& start) const
{
  constexpr double rounding = 1e-24; // of a squared distance
  PlaceInSimplex found;
  double distance2 = 0.;
  double size2 = 0.;
  for (int c = 0; c < 3; ++c)
  {
    size2 += (this->All.High[c] - this->All.Low[c]) * (this->All.High[c] - this->All.Low[c]);
  }
  if ((!isBeside && !this->All.Holds(x.data())) ||
    !this->Tree.FindNearest(x.data(), found, distance2) ||
    (!isBeside && distance2 > rounding * size2))
  {
    return false;
  }
  const vtkIdType number = this->Numbers[found.Simplex];
  start.Cell =
    std::upper_bound(this->Firsts.begin(), this->Firsts.end(), number) - this->Firsts.begin() - 1;
  std::array<double, 4> weights{};
  for (int i = 0; i < 4; ++i)
  {
    weights[i] = found.Weights[i] + 0.1 * (0.25 - found.Weights[i]); // inside of the piece
  }
  start.Weights = LeavePartOfSimplex(3, this->Levels, number - this->Firsts[start.Cell], weights);
  return true;
}

}
