// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ForNumbered.h
 * A parallel loop that numbers what it finds.
 */
#ifndef SubdivisionObjects_ForNumbered_h
#define SubdivisionObjects_ForNumbered_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Loops.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace subdivision
{

/// Calls count(i, number) for each i of [0, size), which adds how many things there are at i, then
/// act(i, number), where `number` is how many there are before i; act adds the same. One thread
/// alone does not count first.
template <typename Id, typename Count, typename Act>
void ForNumbered(vtkIdType size, const Count& count, const Act& act)
{
  constexpr vtkIdType block = 16384;
  const vtkIdType blocks = (size + block - 1) / block;
  const auto run = [size](vtkIdType b, Id number, const auto& body)
  {
    const vtkIdType end = std::min(size, (b + 1) * block);
    for (vtkIdType i = b * block; i < end; ++i)
    {
      body(i, number);
    }
    return number;
  };
  if (vtkSMPTools::GetEstimatedNumberOfThreads() == 1)
  {
    Id number = 0;
    for (vtkIdType b = 0; b < blocks; ++b)
    {
      number = run(b, number, act);
      BetweenLoops::Act();
    }
    return;
  }
  Buffer<Id> starts(blocks + 1);
  const auto forBlocks = [blocks](const auto& body)
  {
    ForRangesOfBlocks(blocks,
      [&body](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType b = begin; b < end; ++b)
        {
          body(b);
        }
      });
  };
  forBlocks([&](vtkIdType b) { starts[b] = run(b, Id(0), count); });
  CountsToOffsets(starts);
  forBlocks([&](vtkIdType b) { run(b, starts[b], act); });
}

}

#endif
