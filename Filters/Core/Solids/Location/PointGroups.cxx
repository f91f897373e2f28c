// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/PointGroups.h"

#include "Core/Memory/Sorting.h"
#include "Core/Solids/Location/MortonCode.h"

#include <cmath>
#include <numeric>

namespace subdivision
{
namespace
{

constexpr int Cells = 16; ///< of the lattice, along an axis
constexpr int Codes = Cells * Cells * Cells;
/// Points in one cell of the last lattice differ by 1e-6 of the box at most.
constexpr int MostDepth = 5;

/// Cells of a box along a space-filling curve.
class Lattice
{
public:
  explicit Lattice(const Box& box)
    : Whole(box)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double width = box.High[c] - box.Low[c];
      this->Scale[c] = width > 0. ? Cells / width : 0.;
    }
  }
  int GetCode(const double x[3]) const
  {
    std::uint64_t places[3];
    for (int c = 0; c < 3; ++c)
    {
      const double place = (x[c] - this->Whole.Low[c]) * this->Scale[c];
      places[c] = place > 0. ? static_cast<std::uint64_t>(std::min(place, Cells - 1.)) : 0;
    }
    return static_cast<int>(GetMortonCode(places));
  }
  /// The cell with the point.
  Box GetCell(const double x[3]) const
  {
    Box cell = this->Whole;
    for (int c = 0; c < 3; ++c)
    {
      if (!(this->Scale[c] > 0.))
      {
        continue;
      }
      const double place = std::floor((x[c] - this->Whole.Low[c]) * this->Scale[c]);
      cell.Low[c] = this->Whole.Low[c] + place / this->Scale[c];
      cell.High[c] = this->Whole.Low[c] + (place + 1.) / this->Scale[c];
    }
    return cell;
  }

private:
  Box Whole;
  double Scale[3];
};

}

PointGroups::PointGroups(const double* points, int size, const Box& box, int most)
  : Order(size)
  , Starts{ 0 }
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  this->Split(points, 0, size, box, most, 0);
}

void PointGroups::Split(
  const double* points, int begin, int end, const Box& box, int most, int depth)
{
  const Lattice lattice(box);
  const int* ids = this->Order.data() + begin;
  auto getCode = [&](int i)
  {
    const double* x = points + 3 * static_cast<vtkIdType>(ids[i]);
    return depth > 0 || box.Holds(x) ? lattice.GetCode(x) : Codes;
  };
  Buffer<int> order;
  std::vector<int> starts;
  SortByKey(end - begin, Codes + 1, getCode, order, starts);
  ForEach(order.size(), [&](vtkIdType i) { order[i] = ids[order[i]]; });
  std::copy(order.begin(), order.end(), this->Order.begin() + begin);
  order = Buffer<int>();

  int first = begin; // of the group that is being made
  auto close = [&](int last)
  {
    if (last > first)
    {
      this->Starts.push_back(last);
    }
    first = last;
  };
  for (int code = 0; code < Codes; ++code)
  {
    const int from = begin + starts[code];
    const int to = begin + starts[code + 1];
    if (to - first > most)
    {
      close(from);
    }
    if (to - from > most && depth < MostDepth)
    {
      const double* x = points + 3 * static_cast<vtkIdType>(this->Order[from]);
      this->Split(points, from, to, lattice.GetCell(x), most, depth + 1);
      first = to;
    }
  }
  close(begin + starts[Codes]);
}

}
