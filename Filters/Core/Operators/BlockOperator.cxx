// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/BlockOperator.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

template <typename Id>
void BlockOperator<Id>::ForRows(const RowsUser& use) const
{
  ForRanges(this->NumberOfRows,
    [&](vtkIdType first, vtkIdType last)
    {
      RowBlock<Id> block; // some 30 KB
      ForBlocks(first, last,
        [&](vtkIdType begin, vtkIdType end)
        {
          block.Clear();
          this->AppendRows(begin, end, block);
          use(block, begin);
        });
    });
}

template <typename Id>
void BlockOperator<Id>::ForEachBlock(const User& use) const
{
  this->ForRows([&use](const RowBlock<Id>& rows, vtkIdType first) { rows.ForRuns(first, use); });
}

template <typename Id>
SparseRows<Id> BlockOperator<Id>::Store() const
{
  constexpr vtkIdType rowsOfBlock = 4096;
  const vtkIdType size = this->NumberOfRows;
  const vtkIdType blocks = (size + rowsOfBlock - 1) / rowsOfBlock;
  SparseRows<Id> rows;
  rows.NumberOfColumns = this->NumberOfColumns;
  rows.Offsets = Buffer<Id>(size + 1);
  std::vector<RowBlock<Id>> parts(static_cast<std::size_t>(blocks));
  const auto append = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType b = begin; b < end; ++b)
    {
      const vtkIdType first = b * rowsOfBlock;
      const vtkIdType last = std::min(size, first + rowsOfBlock);
      this->AppendRows(first, last, parts[b]);
      vtkIdType before = 0;
      for (vtkIdType row = first; row < last; ++row)
      {
        const auto after = static_cast<vtkIdType>(parts[b].GetEnd(row - first));
        rows.Offsets[row] = static_cast<Id>(after - before);
        before = after;
      }
    }
  };
  ForRangesOfBlocks(blocks, append);
  CountsToOffsets(rows.Offsets);
  rows.Columns = Buffer<Id>(rows.Offsets[size]);
  rows.Weights = Buffer<double>(rows.Offsets[size]);
  const auto join = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType b = begin; b < end; ++b)
    {
      const auto entries = static_cast<vtkIdType>(parts[b].GetNumberOfEntries());
      const vtkIdType first = rows.Offsets[b * rowsOfBlock];
      std::copy_n(parts[b].GetColumns(), entries, rows.Columns.begin() + first);
      std::copy_n(parts[b].GetWeights(), entries, rows.Weights.begin() + first);
      parts[b] = RowBlock<Id>();
    }
  };
  ForRangesOfBlocks(blocks, join);
  return rows;
}

SUBDIVISION_COMPILE(class BlockOperator);

}
