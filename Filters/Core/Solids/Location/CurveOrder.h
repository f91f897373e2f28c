// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveOrder.h
 * An order of points in which most neighbours are near each other.
 */
#ifndef SubdivisionObjects_CurveOrder_h
#define SubdivisionObjects_CurveOrder_h

#include "Core/Memory/Sorting.h"
#include "Core/Solids/Location/Box.h"

#include <cstdint>

namespace subdivision
{

/// The Morton code of a cell: it interleaves the bits of its three places, each of up to 21 bits.
inline std::uint64_t GetMortonCode(const std::uint64_t places[3])
{
  std::uint64_t code = 0;
  for (int c = 0; c < 3; ++c)
  {
    std::uint64_t bits = places[c];
    bits = (bits | bits << 32) & 0x001f00000000ffffULL;
    bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
    bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
    bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
    bits = (bits | bits << 2) & 0x1249249249249249ULL;
    code |= bits << c;
  }
  return code;
}

/// The numbers of [0, size) in the order of a space-filling curve through the box; point(i, x)
/// gives point i. Equal points stay in ascending order. Points that are not finite are somewhere.
template <typename Point>
Buffer<vtkIdType> SortAlongCurve(vtkIdType size, const Box& box, const Point& point)
{
  struct Item
  {
    std::uint64_t Code;
    vtkIdType Number;
  };
  constexpr double cells = 2097151.; // 21 bits
  double scale[3];
  for (int c = 0; c < 3; ++c)
  {
    scale[c] = box.High[c] > box.Low[c] ? 1. / (box.High[c] - box.Low[c]) : 0.;
  }
  Buffer<Item> items(size);
  ForEach(size,
    [&](vtkIdType i)
    {
      double x[3];
      std::uint64_t places[3];
      point(i, x);
      for (int c = 0; c < 3; ++c)
      {
        const double place = (x[c] - box.Low[c]) * scale[c] * cells;
        places[c] = place > 0. ? static_cast<std::uint64_t>(std::min(place, cells)) : 0;
      }
      items[i] = { GetMortonCode(places), i };
    });
  StableSort(items, [](const Item& a, const Item& b) { return a.Code < b.Code; });
  Buffer<vtkIdType> order(size);
  ForEach(size, [&](vtkIdType i) { order[i] = items[i].Number; });
  return order;
}

}

#endif
