// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForBlocks.h
 * Loops over blocks of rows.
 */
#ifndef SubdivisionObjects_ForBlocks_h
#define SubdivisionObjects_ForBlocks_h

#include "Core/Memory/Buffer.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace subdivision
{

/// Rows that are made and applied together: they fit into a core's own cache, so that each array
/// after the first finds them there.
constexpr vtkIdType BlockSize = 256;

/// block(begin, end) over blocks of at most `size` that cover [begin, end).
template <typename Block>
void ForBlocks(vtkIdType begin, vtkIdType end, const Block& block, vtkIdType size = BlockSize)
{
  for (; begin < end; begin += size)
  {
    block(begin, std::min(begin + size, end));
  }
}

/// The same over [0, size) in several threads.
template <typename Block>
void ForBlocksInThreads(vtkIdType size, const Block& block)
{
  ForRanges(size, [&block](vtkIdType begin, vtkIdType end) { ForBlocks(begin, end, block); });
}

/// Calls body(kind, begin, end) for ranges that cover [0, counts[kind]) for each kind. This is one
/// parallel loop, so that threads do not wait for each other between two kinds.
template <std::size_t Kinds, typename Body>
void ForKinds(const std::array<vtkIdType, Kinds>& counts, const Body& body)
{
  ForRanges(std::accumulate(counts.begin(), counts.end(), vtkIdType(0)),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t kind = 0; kind < Kinds; ++kind)
      {
        const vtkIdType first = std::max(begin, vtkIdType(0));
        const vtkIdType last = std::min(end, counts[kind]);
        if (first < last)
        {
          body(kind, first, last);
        }
        begin -= counts[kind];
        end -= counts[kind];
      }
    });
}

}

#endif
