// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SparseRows.h
 * An operator with explicit weights, for rows that rings and rules (Stencils.h) cannot express.
 */
#ifndef SubdivisionObjects_SparseRows_h
#define SubdivisionObjects_SparseRows_h

#include "Core/Operators/PointOperator.h"

namespace subdivision
{

template <typename Id>
struct SparseRows : PointOperator
{
  vtkIdType NumberOfColumns = 0;
  Buffer<Id> Offsets; ///< one more than rows
  Buffer<Id> Columns;
  Buffer<double> Weights;

  vtkIdType GetNumberOfColumns() const override { return this->NumberOfColumns; }
  vtkIdType GetNumberOfRows() const override
  {
    return this->Offsets.empty() ? 0 : this->Offsets.size() - 1;
  }
  std::size_t GetMemorySize() const
  {
    return this->Offsets.GetMemorySize() + this->Columns.GetMemorySize() +
      this->Weights.GetMemorySize();
  }

  /// Rows [begin, end). A row of one entry of weight 1 copies; an entry of weight 0 is not read.
  WeightedRows<Id> GetRows(vtkIdType begin, vtkIdType end) const;
  void ForEachBlock(const User& use) const override;
};

/// The product outer * inner: to apply it is to apply first `inner`, then `outer`, up to rounding.
/// The columns of a row stand in the order in which the sum over `outer` first reaches them.
template <typename Id>
SparseRows<Id> Multiply(const SparseRows<Id>& outer, const SparseRows<Id>& inner);

}

#endif
