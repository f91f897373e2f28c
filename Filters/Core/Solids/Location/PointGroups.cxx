// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/PointGroups.h"

#include "Core/Memory/Ahead.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/Location/MortonCode.h"

#include <cmath>
#include <functional>

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
    for (int i = 0; i < 3 * Cells; ++i)
    {
      std::uint64_t places[3] = { 0, 0, 0 };
      places[i / Cells] = i % Cells;
      this->Codes[i / Cells][i % Cells] = static_cast<int>(GetMortonCode(places));
    }
  }
  int GetCode(const double x[3]) const
  {
    int code = 0;
    for (int c = 0; c < 3; ++c)
    {
      const double place = (x[c] - this->Whole.Low[c]) * this->Scale[c];
      code |= this->Codes[c][static_cast<int>(std::max(0., std::min(place, Cells - 1.)))];
    }
    return code;
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
  int Codes[3][Cells]; ///< of the places along each axis
};

}

PointGroups::PointGroups(const double* points, int size, const Box& box, int most)
  : Starts{ 0 }
{
  this->Split(points, 0, size, box, most, 0);
}

/// Sorts the points by the cells of a lattice, and closes groups.
void PointGroups::Split(
  const double* points, int begin, int end, const Box& box, int most, int depth)
{
  const Lattice lattice(box);
  std::vector<int> starts;
  if (depth == 0)
  {
    constexpr vtkIdType ahead = 64; // points
    const auto getCode = [&](int i)
    {
      const double* x = points + 3 * static_cast<vtkIdType>(i);
      AskFor(x, 3 * ahead);
      return box.Holds(x) ? lattice.GetCode(x) : Codes;
    };
    SortByKey(end, Codes + 1, getCode, this->Order, starts);
  }
  else
  {
    const int* ids = this->Order.data() + begin;
    const auto getCode = [&](int i)
    { return lattice.GetCode(points + 3 * static_cast<vtkIdType>(ids[i])); };
    Buffer<int> order;
    SortByKey(end - begin, Codes + 1, getCode, order, starts);
    ForEach(order.size(), [&](vtkIdType i) { order[i] = ids[order[i]]; });
    std::copy(order.begin(), order.end(), this->Order.begin() + begin);
  }
  // Half of the codes of a box along the curve are half of the box.
  const std::function<void(int, int)> close = [&](int code, int codes)
  {
    const int from = begin + starts[code];
    const int to = begin + starts[code + codes];
    if (to - from > most && codes > 1)
    {
      close(code, codes / 2);
      close(code + codes / 2, codes / 2);
    }
    else if (to - from > most && depth < MostDepth)
    {
      const double* x = points + 3 * static_cast<vtkIdType>(this->Order[from]);
      this->Split(points, from, to, lattice.GetCell(x), most, depth + 1);
    }
    else if (to > from)
    {
      this->Starts.push_back(to);
    }
  };
  close(0, Codes);
}

}
