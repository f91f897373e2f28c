// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/BlockOperator.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
void BlockOperator<Id>::ForRows(const User& use) const
{
  ForRanges(this->NumberOfRows,
    [&](vtkIdType begin, vtkIdType end)
    {
      constexpr vtkIdType rowsPerBlock = 256; // some 30 KB
      RowBlock<Id> block;
      for (vtkIdType first = begin; first < end; first += rowsPerBlock)
      {
        block.Clear();
        this->AppendRows(first, std::min(end, first + rowsPerBlock), block);
        use(block, first);
      }
    });
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

template class BlockOperator<int>;
template class BlockOperator<long long>;

}
