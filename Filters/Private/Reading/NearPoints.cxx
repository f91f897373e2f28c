// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/NearPoints.h"

#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace subdivision
{
namespace
{

using Place = std::array<double, 3>; ///< a cell of the grid, or coordinates: z first

/// The cells of the grid that have points, ascending: cell c has the sorted points from Starts[c]
/// to before Starts[c + 1].
class Grid
{
public:
  Grid(const double* x, const std::vector<Place>& places, const Buffer<vtkIdType>& sorted,
    const std::vector<vtkIdType>& points)
    : X(x)
    , Sorted(sorted)
    , Points(points)
  {
    for (const vtkIdType i : InTurn(sorted.size()))
    {
      const Place& place = places[sorted[i]];
      if (this->Cells.empty() || this->Cells.back() != place)
      {
        this->Cells.push_back(place);
        this->Starts.push_back(i);
      }
    }
    this->Starts.push_back(sorted.size());
  }

  /// Joins the points of each cell.
  void JoinCells(Sets& sets) const
  {
    for (const std::size_t c : InTurn(this->Cells.size()))
    {
      for (vtkIdType i = this->Starts[c] + 1; i < this->Starts[c + 1]; ++i)
      {
        sets.Join(this->Starts[c], i);
      }
    }
  }
  /// Joins cells that are up to two rows above each other, and two cells apart in their row.
  void JoinNeighbours(double tolerance, Sets& sets) const
  {
    for (int row = 0; row < 13; ++row) // z = 0, y = 0 to 2; then z = 1 and 2, y = -2 to 2
    {
      const double z = row < 3 ? 0. : (row - 3) / 5 + 1.;
      const double y = row < 3 ? row : (row - 3) % 5 - 2.;
      std::size_t other = 0;
      for (const std::size_t c : InTurn(this->Cells.size()))
      {
        const Place& cell = this->Cells[c];
        const Place first = { cell[0] + z, cell[1] + y, cell[2] + (row == 0 ? 1. : -2.) };
        while (other < this->Cells.size() && this->Cells[other] < first)
        {
          ++other;
        }
        const Place last = { first[0], first[1], cell[2] + 2. };
        for (std::size_t o = other; o < this->Cells.size() && this->Cells[o] <= last; ++o)
        {
          if (sets.Find(this->Starts[c]) != sets.Find(this->Starts[o]) &&
            this->HasNear(c, o, tolerance))
          {
            sets.Join(this->Starts[c], this->Starts[o]);
          }
        }
      }
    }
  }

private:
  const double* GetPoint(vtkIdType i) const { return this->X + 3 * this->Points[this->Sorted[i]]; }
  /// The points of a cell that may be near to some of another one.
  std::vector<const double*> ListNear(std::size_t cell, std::size_t other, double tolerance) const
  {
    Box box;
    for (vtkIdType i = this->Starts[other]; i < this->Starts[other + 1]; ++i)
    {
      box.Add(this->GetPoint(i));
    }
    std::vector<const double*> near;
    for (vtkIdType i = this->Starts[cell]; i < this->Starts[cell + 1]; ++i)
    {
      const double* x = this->GetPoint(i);
      double away[3];
      for (int k = 0; k < 3; ++k)
      {
        away[k] = std::max({ 0., box.Low[k] - x[k], x[k] - box.High[k] });
      }
      if (std::hypot(away[0], away[1], away[2]) <= tolerance)
      {
        near.push_back(x);
      }
    }
    return near;
  }
  bool HasNear(std::size_t a, std::size_t b, double tolerance) const
  {
    const std::vector<const double*> others = this->ListNear(b, a, tolerance);
    for (const double* p : this->ListNear(a, b, tolerance))
    {
      for (const double* q : others)
      {
        if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= tolerance)
        {
          return true;
        }
      }
    }
    return false;
  }

  const double* X;
  const Buffer<vtkIdType>& Sorted;
  const std::vector<vtkIdType>& Points;
  std::vector<Place> Cells;
  std::vector<vtkIdType> Starts;
};

bool IsFinite(const double* x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

}

double GetDiagonal(const Box& box)
{
  return box.High[0] >= box.Low[0]
    ? std::hypot(box.High[0] - box.Low[0], box.High[1] - box.Low[1], box.High[2] - box.Low[2])
    : 0.;
}

Buffer<vtkIdType> FindFirstOfNear(
  const double* x, const std::vector<vtkIdType>& points, double tolerance, const PointOrder& order)
{
  const auto size = static_cast<vtkIdType>(points.size());
  double largest = 0.;
  for (const vtkIdType point : InTurn(points))
  {
    for (int k = 0; k < 3; ++k)
    {
      const double value = std::abs(x[3 * point + k]);
      largest = std::isfinite(value) ? std::max(largest, value) : largest;
    }
  }
  tolerance = tolerance > 1e-15 * largest ? tolerance : 0.; // cells of the grid have exact numbers
  // All points of a cell are near each other: its diagonal is 0.999 times the tolerance.
  const double side = 0.577 * tolerance;
  std::vector<Place> places(points.size());
  ForEach(size,
    [&](vtkIdType i)
    {
      const double* p = x + 3 * points[i];
      for (int k = 0; k < 3; ++k)
      {
        places[i][2 - k] = tolerance > 0. ? std::floor(p[k] / side) : p[k] + 0.; // -0 is 0
      }
    });
  Buffer<vtkIdType> firsts(size);
  std::copy(points.begin(), points.end(), firsts.begin());
  std::vector<vtkIdType> finite;
  for (const vtkIdType i : InTurn(size))
  {
    if (IsFinite(x + 3 * points[i]))
    {
      finite.push_back(i);
    }
  }
  Buffer<vtkIdType> sorted(static_cast<vtkIdType>(finite.size()));
  std::copy(finite.begin(), finite.end(), sorted.begin());
  StableSort(sorted, [&](vtkIdType a, vtkIdType b)
    { return places[a] != places[b] ? places[a] < places[b] : order(points[a], points[b]); });
  Sets sets(sorted.size());
  const Grid grid(x, places, sorted, points);
  grid.JoinCells(sets);
  if (tolerance > 0.)
  {
    grid.JoinNeighbours(tolerance, sets);
  }
  Buffer<vtkIdType> leasts(sorted.size(), -1); // of each set
  for (const bool isAll : { false, true })
  {
    for (const vtkIdType i : InTurn(sorted.size()))
    {
      vtkIdType& least = leasts[sets.Find(i)];
      const vtkIdType point = points[sorted[i]];
      if (isAll)
      {
        firsts[sorted[i]] = least;
      }
      else if (least < 0 || order(point, least))
      {
        least = point;
      }
    }
  }
  return firsts;
}

}
