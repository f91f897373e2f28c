// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockOperator.h
 * An operator whose rows are made while they are applied, block by block.
 */
#ifndef SubdivisionObjects_BlockOperator_h
#define SubdivisionObjects_BlockOperator_h

#include "Core/Operators/RowBlock.h"

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

  /// Receives a block of consecutive rows, the first of which is row `first`. ForRows passes each
  /// row exactly once, in any order and from many threads.
  using User = std::function<void(const RowBlock<Id>& rows, vtkIdType first)>;
  void ForRows(const User& use) const;

  /// out = S in, for `components` interleaved values per column. Integers are rounded.
  template <typename T>
  void Apply(const T* in, T* out, int components) const
  {
    this->ForRows([in, out, components](const RowBlock<Id>& rows, vtkIdType first)
      { rows.Apply(in, out + first * components, components); });
  }

  /// The same as stored rows.
  SparseRows<Id> Store() const;

private:
  vtkIdType NumberOfColumns;
  vtkIdType NumberOfRows;
  Append AppendRows;
};

}

#endif
