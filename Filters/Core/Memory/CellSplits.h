// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellSplits.h
 * Levels of which only some cells are made, with the cells on which these depend.
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
  /// the cells that went on before, at first of all cells.
  std::vector<std::vector<char>> Flags;
  /// The answer of a run: whether a cell of the last of these levels goes on, for each one whose
  /// children are in the output. Empty: the run took no notice, and its output is the whole.
  std::vector<char> Made;

  /// `goesOn` has a flag for each cell of a level whose parent goes on; leaves the flags of cells
  /// that go on. Flags may begin with cells that are not listed.
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
