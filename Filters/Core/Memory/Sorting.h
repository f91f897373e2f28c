// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sorting.h
 * Sorting in threads, which can be stopped.
 */
#ifndef SubdivisionObjects_Sorting_h
#define SubdivisionObjects_Sorting_h

#include "Core/Memory/Buffer.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace subdivision
{

/// As std::stable_sort, for a std::vector or a Buffer. Threads sort blocks and then merge pairs of
/// them, so that the result does not depend on their number. Needs as much memory again.
template <typename List, typename Less>
void StableSort(List& values, const Less& less)
{
  constexpr vtkIdType block = 1 << 15;
  const auto size = static_cast<vtkIdType>(values.size());
  List other(size > block ? values.size() : 0);
  // Calls act(begin, middle, end) for pairs of neighbours that are `width` long.
  const auto forPairs = [size](vtkIdType width, const auto& act)
  {
    ForRangesOfBlocks((size + 2 * width - 1) / (2 * width),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType pair = first; pair < last; ++pair)
        {
          const vtkIdType begin = 2 * pair * width;
          act(begin, std::min(size, begin + width), std::min(size, begin + 2 * width));
        }
      });
  };
  forPairs(block / 2, [&](vtkIdType begin, vtkIdType, vtkIdType end)
    { std::stable_sort(values.begin() + begin, values.begin() + end, less); });
  for (vtkIdType width = block; width < size; width *= 2)
  {
    forPairs(width,
      [&](vtkIdType begin, vtkIdType middle, vtkIdType end)
      {
        std::merge(values.begin() + begin, values.begin() + middle, values.begin() + middle,
          values.begin() + end, other.begin() + begin, less);
      });
    std::swap(values, other);
  }
}

/// Sorts values, and keeps one of several equal ones.
template <typename T>
void SortDistinct(std::vector<T>& values)
{
  StableSort(values, std::less<>());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}

#endif
