// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/NearPoints.h"

#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace subdivision
{
namespace
{

using Place = std::array<double, 3>; ///< a cell of the grid, z first

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

/// A number for a place, 0 where it is not finite.
std::uint64_t HashPlace(const double* x)
{
  std::uint64_t hash = 1;
  for (int k = 0; k < 3; ++k)
  {
    const double value = x[k] + 0.; // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
  }
  return IsFinite(x) ? std::max<std::uint64_t>(hash, 1) : 0;
}

/// FindFirstOfNear without a tolerance: a table from the hashes of places takes a fraction of the
/// time of sorting.
Buffer<vtkIdType> FindFirstOfEqual(
  const double* x, const std::vector<vtkIdType>& points, const PointOrder& order)
{
  const auto size = static_cast<vtkIdType>(points.size());
  Buffer<std::uint64_t> hashes(size);
  ForEach(size, [&](vtkIdType i) { hashes[i] = HashPlace(x + 3 * points[i]); });
  vtkIdType slots = 16;
  while (slots < size + size / 2)
  {
    slots *= 2;
  }
  Buffer<vtkIdType> table(slots, -1); // of places the indices of first points
  Buffer<vtkIdType> places(size);     // of each point the index of the first at its place
  Buffer<vtkIdType> firsts(size);     // of each place, by this index
  for (const vtkIdType i : InTurn(size))
  {
    const double* here = x + 3 * points[i];
    auto slot = static_cast<vtkIdType>(hashes[i] % static_cast<std::uint64_t>(slots));
    const auto isOther = [&](vtkIdType known)
    { return hashes[known] != hashes[i] || !std::equal(here, here + 3, x + 3 * points[known]); };
    while (hashes[i] != 0 && table[slot] >= 0 && isOther(table[slot]))
    {
      slot = (slot + 1) % slots;
    }
    const bool isNew = hashes[i] == 0 || table[slot] < 0;
    places[i] = isNew ? i : table[slot];
    table[slot] = isNew && hashes[i] != 0 ? i : table[slot];
    vtkIdType& first = firsts[places[i]];
    first = isNew || order(points[i], first) ? points[i] : first;
  }
  for (vtkIdType i = size - 1; i >= 0; --i) // places come before points
  {
    firsts[i] = firsts[places[i]];
  }
  return firsts;
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
  if (tolerance <= 1e-15 * largest) // else cells of the grid have exact numbers
  {
    return FindFirstOfEqual(x, points, order);
  }
  // All points of a cell are near each other: its diagonal is 0.999 times the tolerance.
  const double side = 0.577 * tolerance;
  std::vector<Place> places(points.size());
  ForEach(size,
    [&](vtkIdType i)
    {
      const double* p = x + 3 * points[i];
      for (int k = 0; k < 3; ++k)
      {
        places[i][2 - k] = std::floor(p[k] / side);
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
  grid.JoinNeighbours(tolerance, sets);
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
