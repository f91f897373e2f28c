// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/SolidPieces.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/Limits/PlacePolynomial.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

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
{
  const auto firsts = std::make_shared<Buffer<vtkIdType>>(cells.GetNumberOfCells() + 1);
  ForEach(cells.GetNumberOfCells(),
    [&](vtkIdType c) { (*firsts)[c] = vtkIdType(1) << (levels * cells.Dimensions[c]); });
  CountsToOffsets(*firsts);
  std::vector<int> corners;
  const auto numbers = std::make_shared<std::vector<vtkIdType>>();
  vtkNew<vtkIdList> ids;
  ForEachInTurn(fine->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      if (fine->GetCellType(c) == VTK_TETRA)
      {
        fine->GetCellPoints(c, ids);
        std::transform(ids->begin(), ids->end(), std::back_inserter(corners),
          [](vtkIdType id) { return static_cast<int>(id); });
        numbers->push_back(c);
      }
    });
  this->Locate = [firsts, numbers, levels](
                   vtkIdType piece, const std::array<double, 4>& weights, NearestPlace& start)
  {
    const vtkIdType number = (*numbers)[piece];
    start.Cell = std::upper_bound(firsts->begin(), firsts->end(), number) - firsts->begin() - 1;
    start.Weights = LeavePartOfSimplex(3, levels, number - (*firsts)[start.Cell], weights);
  };
  this->Build(fine, corners);
}

SolidPieces::SolidPieces(vtkDataSet* fine, const std::vector<int>& corners, LocateInPiece locate)
  : Locate(std::move(locate))
{
  this->Build(fine, corners);
}

void SolidPieces::Build(vtkDataSet* fine, const std::vector<int>& corners)
{
  this->Points = Buffer<double>(3 * fine->GetNumberOfPoints());
  ForEachInTurn(fine->GetNumberOfPoints(),
    [&](vtkIdType i) { fine->GetPoint(i, this->Points.data() + 3 * i); });
  this->Corners = Buffer<int>(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), this->Corners.begin());
  for (const int corner : InTurn(corners))
  {
    this->All.Add(this->Points.data() + 3 * vtkIdType(corner));
  }
  if (!corners.empty())
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
  std::array<double, 4> weights{};
  for (int i = 0; i < 4; ++i)
  {
    weights[i] = found.Weights[i] + 0.1 * (0.25 - found.Weights[i]); // inside of the piece
  }
  this->Locate(found.Simplex, weights, start);
  return true;
}

}
