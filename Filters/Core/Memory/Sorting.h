// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sorting.h
 * Sorting in threads, which can be stopped.
 */
#ifndef SubdivisionObjects_Sorting_h
#define SubdivisionObjects_Sorting_h

#include "Core/Memory/Buffer.h"

#include <algorithm>
#include <cstdint>
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

/// Sorts the numbers of [0, size) by key(i), which is less than `keys` <= 65536; numbers with equal
/// keys stay in ascending order. Key k has order[starts[k] .. starts[k + 1]).
template <typename Key>
void SortByKey(int size, int keys, const Key& key, Buffer<int>& order, std::vector<int>& starts)
{
  const int block = std::max(1 << 14, size / 64 + 1);
  const int blocks = (size + block - 1) / block;
  const auto forBlocks = [=](const auto& act) // act(b, begin, end)
  {
    ForRangesOfBlocks(blocks,
      [&](vtkIdType first, vtkIdType last)
      {
        for (auto b = static_cast<int>(first); b < last; ++b)
        {
          act(b, b * block, std::min(size, static_cast<int>((b + 1LL) * block)));
        }
      });
  };
  Buffer<std::uint16_t> found(size);
  Buffer<int> places(vtkIdType(keys) * blocks + 1); // by key, then by block
  forBlocks(
    [&](int b, int begin, int end)
    {
      std::vector<int> counts(keys, 0);
      for (int i = begin; i < end; ++i)
      {
        found[i] = static_cast<std::uint16_t>(key(i));
        ++counts[found[i]];
      }
      for (int k = 0; k < keys; ++k)
      {
        places[vtkIdType(k) * blocks + b] = counts[k];
      }
    });
  CountsToOffsets(places);
  order = Buffer<int>(size);
  forBlocks(
    [&](int b, int begin, int end)
    {
      std::vector<int> next(keys);
      for (int k = 0; k < keys; ++k)
      {
        next[k] = places[vtkIdType(k) * blocks + b];
      }
      for (int i = begin; i < end; ++i)
      {
        order[next[found[i]]++] = i;
      }
    });
  starts.resize(keys + 1);
  for (int k = 0; k <= keys; ++k)
  {
    starts[k] = places[vtkIdType(k) * blocks];
  }
}

}

#endif
