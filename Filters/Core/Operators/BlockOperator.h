// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockOperator.h
 * An operator whose rows are made while they are applied, block by block.
 */
#ifndef SubdivisionObjects_BlockOperator_h
#define SubdivisionObjects_BlockOperator_h

#include "Core/Operators/RowBlock.h"
#include "Core/Operators/SparseRows.h"

#include <functional>

namespace subdivision
{

template <typename Id>
class BlockOperator : public PointOperator
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

  vtkIdType GetNumberOfColumns() const override { return this->NumberOfColumns; }
  vtkIdType GetNumberOfRows() const override { return this->NumberOfRows; }

  /// Receives a block of consecutive rows, the first of which is row `first`. ForRows passes each
  /// row exactly once, in any order and from many threads.
  using RowsUser = std::function<void(const RowBlock<Id>& rows, vtkIdType first)>;
  void ForRows(const RowsUser& use) const;
  void ForEachBlock(const User& use) const override;

  /// The same as stored rows.
  SparseRows<Id> Store() const;

private:
  vtkIdType NumberOfColumns;
  vtkIdType NumberOfRows;
  Append AppendRows;
};

}

#endif
