// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockOperator.h
 * An operator whose rows are made while they are applied, block by block.
 */
#ifndef SubdivisionObjects_BlockOperator_h
#define SubdivisionObjects_BlockOperator_h

#include "RowBlock.h"

#include <functional>

namespace subdivision
{

template <typename Id>
class BlockOperator
{
public:
  /// Appends rows [begin, end); called from many threads.
  using Append = std::function<void(vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)>;

  BlockOperator(vtkIdType numberOfColumns, vtkIdType numberOfRows, Append append)
    : NumberOfColumns(numberOfColumns)
    , NumberOfRows(numberOfRows)
    , AppendRows(std::move(append))
  {
  }

  vtkIdType GetNumberOfColumns() const { return this->NumberOfColumns; }
  vtkIdType GetNumberOfRows() const { return this->NumberOfRows; }

  /// out = S in, for `components` interleaved values per column. Integers are rounded.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;

  /// The same as stored rows.
  SparseRows<Id> Store() const;

private:
  vtkIdType NumberOfColumns;
  vtkIdType NumberOfRows;
  Append AppendRows;
};

}

#endif
