// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplexTable.h
 * Finds simplices by their corners, among those at places.
 */
#ifndef SubdivisionObjects_SimplexTable_h
#define SubdivisionObjects_SimplexTable_h

#include "Core/Memory/Loops.h"
#include "Core/Solids/Limits/PlaceLimits.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace subdivision
{

/// Flags vertices that are corners of the simplices of places: of solids, or of all others.
template <typename Id>
Buffer<unsigned char> FlagCorners(
  vtkIdType vertices, const std::vector<LimitPlace<Id>>& places, bool ofSolids)
{
  Buffer<unsigned char> isCorner(vertices, 0);
  for (const LimitPlace<Id>& place : InTurn(places))
  {
    for (int i = 0; (place.Dimension == 3) == ofSolids && i <= place.Dimension; ++i)
    {
      isCorner[place.Corners[i]] = 1;
    }
  }
  return isCorner;
}

template <typename Id, std::size_t Corners>
class SimplexTable
{
public:
  using Simplex = std::array<Id, Corners>;

  SimplexTable() = default;
  /// Takes the simplices get(0) to get(size - 1) all of whose corners have a flag.
  template <typename Get>
  SimplexTable(vtkIdType size, const Buffer<unsigned char>& isCorner, const Get& get)
  {
    ForEachInTurn(size,
      [&](vtkIdType i)
      {
        Simplex simplex = get(i);
        if (std::all_of(simplex.begin(), simplex.end(), [&](Id v) { return isCorner[v] != 0; }))
        {
          std::sort(simplex.begin(), simplex.end());
          this->Simplices.emplace_back(simplex, static_cast<Id>(i));
        }
      });
    std::sort(this->Simplices.begin(), this->Simplices.end());
  }
  /// The same, `vertices`: of one simplex after the other.
  SimplexTable(vtkIdType size, const Buffer<unsigned char>& isCorner, const Buffer<Id>& vertices)
    : SimplexTable(size, isCorner,
        [&vertices](vtkIdType i)
        {
          Simplex simplex;
          std::copy_n(vertices.data() + Corners * i, Corners, simplex.begin());
          return simplex;
        })
  {
  }
  /// The number of a simplex, whatever the order of its corners; -1: there is none.
  Id Find(const Id* corners) const
  {
    Simplex simplex;
    std::copy_n(corners, Corners, simplex.begin());
    std::sort(simplex.begin(), simplex.end());
    const auto found = std::lower_bound(this->Simplices.begin(), this->Simplices.end(), simplex,
      [](const auto& listed, const auto& wanted) { return listed.first < wanted; });
    return found == this->Simplices.end() || found->first != simplex ? Id(-1) : found->second;
  }

private:
  std::vector<std::pair<Simplex, Id>> Simplices; ///< ascending
};

}

#endif
