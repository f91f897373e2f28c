// SPDX-License-Identifier: BSD-3-Clause
#include "BlockOperator.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
template <typename T>
void BlockOperator<Id>::Apply(const T* in, T* out, int components) const
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
        T* result = out + first * components;
        switch (components)
        {
          case 1:
            block.template Apply<1>(in, result, components);
            break;
          case 3:
            block.template Apply<3>(in, result, components);
            break;
          default:
            block.template Apply<0>(in, result, components);
            break;
        }
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

#define SUBDIVISION_APPLY(Id, T) template void BlockOperator<Id>::Apply(const T*, T*, int) const
#define SUBDIVISION_BLOCK_OPERATOR(Id)                                                             \
  template class BlockOperator<Id>;                                                                \
  SUBDIVISION_APPLY(Id, float);                                                                    \
  SUBDIVISION_APPLY(Id, double);                                                                   \
  SUBDIVISION_APPLY(Id, char);                                                                     \
  SUBDIVISION_APPLY(Id, signed char);                                                              \
  SUBDIVISION_APPLY(Id, unsigned char);                                                            \
  SUBDIVISION_APPLY(Id, short);                                                                    \
  SUBDIVISION_APPLY(Id, unsigned short);                                                           \
  SUBDIVISION_APPLY(Id, int);                                                                      \
  SUBDIVISION_APPLY(Id, unsigned int);                                                             \
  SUBDIVISION_APPLY(Id, long);                                                                     \
  SUBDIVISION_APPLY(Id, unsigned long);                                                            \
  SUBDIVISION_APPLY(Id, long long);                                                                \
  SUBDIVISION_APPLY(Id, unsigned long long)
SUBDIVISION_BLOCK_OPERATOR(int);
SUBDIVISION_BLOCK_OPERATOR(long long);

}
