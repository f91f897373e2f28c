// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellSplits.h
 * Levels of which only some cells are made, with what these depend on.
 */
#ifndef SubdivisionObjects_CellSplits_h
#define SubdivisionObjects_CellSplits_h

#include <algorithm>
#include <vector>

namespace subdivision
{

struct CellSplits
{
  /// Which cells of levels 1, 2, ... go on, in the order of the output: one flag for each child of
  /// those that went on before, at first of all.
  std::vector<std::vector<char>> Flags;
  /// What a run says: of each cell of the last of these levels that its output has children of,
  /// whether it goes on. Empty: the run took no notice, and its output is the whole.
  std::vector<char> Made;

  /// Of the cells of a level, where `goesOn` has those whose parent goes on, leaves those that do.
  /// Flags may begin with cells that are not in that list.
  void Leave(int level, std::vector<char>& goesOn) const
  {
    auto flag = this->Flags[level - 1].end() -
      std::count_if(goesOn.begin(), goesOn.end(), [](char cell) { return cell != 0; });
    for (char& cell : goesOn)
    {
      cell = cell && *flag++;
    }
  }
};

}

#endif
