// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CornerRows.h
 * An operator whose rows are weighted means of the corners of a simplex. Nearly all simplices have
 * four corners. So each row has room for four entries, needs no offsets, and is summed in a loop of
 * fixed length.
 */
#ifndef SubdivisionObjects_CornerRows_h
#define SubdivisionObjects_CornerRows_h

#include "Core/Operators/SparseRows.h"

namespace subdivision
{

struct CornerRows : PointOperator
{
  vtkIdType NumberOfColumns = 0;
  Buffer<CornerRow> Rows;

  vtkIdType GetNumberOfColumns() const override { return this->NumberOfColumns; }
  vtkIdType GetNumberOfRows() const override { return this->Rows.size(); }
  /// Entries of weight 0 are read, unlike in SparseRows. The result of an empty row has no meaning.
  void ForEachBlock(const User& use) const override;
  std::size_t GetMemorySize() const { return this->Rows.GetMemorySize(); }

  /// The same operator without entries of weight 0. It needs less than 2^29 rows, so that offsets
  /// fit in int.
  SparseRows<int> ToSparseRows() const;
};

}

#endif
