// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/BlockOperator.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"

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
  this->ForRows([&use](const RowBlock<Id>& rows, vtkIdType first) { use(rows.GetRows(first)); });
}

template <typename Id>
SparseRows<Id> BlockOperator<Id>::Store() const
{
  RowBlock<Id> block;
  this->AppendRows(0, this->NumberOfRows, block);
  SparseRows<Id> rows;
  rows.NumberOfColumns = this->NumberOfColumns;
  rows.Offsets = Buffer<Id>(this->NumberOfRows + 1);
  rows.Offsets[0] = 0;
  for (vtkIdType row = 0; row < this->NumberOfRows; ++row)
  {
    rows.Offsets[row + 1] = static_cast<Id>(block.GetEnd(row));
  }
  const vtkIdType entries = static_cast<vtkIdType>(block.GetNumberOfEntries());
  rows.Columns = Buffer<Id>(entries);
  rows.Weights = Buffer<double>(entries);
  std::copy(block.GetColumns(), block.GetColumns() + entries, rows.Columns.begin());
  std::copy(block.GetWeights(), block.GetWeights() + entries, rows.Weights.begin());
  return rows;
}

SUBDIVISION_COMPILE(class BlockOperator);

}
