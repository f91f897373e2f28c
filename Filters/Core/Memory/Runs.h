// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Runs.h
 * Equal neighbours of a sorted list.
 */
#ifndef SubdivisionObjects_Runs_h
#define SubdivisionObjects_Runs_h

#include "Core/Memory/Loops.h"

#include <cstddef>

namespace subdivision
{

/// Calls visit(begin, end) for each run of values that have the same key.
template <typename List, typename Key, typename Visit>
void ForEachRun(const List& values, const Key& key, const Visit& visit)
{
  Turns turns;
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end, turns.Next())
  {
    for (end = begin; end < values.size() && key(values[end]) == key(values[begin]); ++end)
    {
    }
    visit(begin, end);
  }
}

}

#endif
