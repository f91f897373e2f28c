// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CornerRows.h
 * An operator whose rows are weighted means of the corners of a simplex. Nearly all simplices have
 * four corners. So each row has four entries, needs no offsets, and is summed in a loop of fixed
 * length. Rows of a place in a simplex are stored as 3 weights and one number, and completed block
 * by block while they are applied: reading memory takes most of the time.
 */
#ifndef SubdivisionObjects_CornerRows_h
#define SubdivisionObjects_CornerRows_h

#include "Core/Operators/SparseRows.h"

#include <array>

namespace subdivision
{

/// The weights of all corners of a simplex: the first one is 1 minus the others.
inline std::array<double, 4> CompleteWeights(const double others[3])
{
  return { 1. - others[0] - others[1] - others[2], others[0], others[1], others[2] };
}

struct CornerRows : PointOperator
{
  vtkIdType NumberOfColumns = 0;
  const int* Corners = nullptr; ///< 4 of each simplex; they belong to others, and outlive the rows
  Buffer<int> Simplices;        ///< of each row; less than 0: -1 - i for row i of Others
  Buffer<double> Weights;   ///< 3 for each row, of the corners 1 to 3; empty if all are in Others
  Buffer<CornerRow> Others; ///< rows whose weights do not follow from three of them

  vtkIdType GetNumberOfColumns() const override { return this->NumberOfColumns; }
  vtkIdType GetNumberOfRows() const override { return this->Simplices.size(); }
  CornerRow GetRow(vtkIdType i) const
  {
    CornerRow row;
    this->Complete(i, row);
    return row;
  }
  bool IsEmpty(vtkIdType i) const
  {
    return this->Simplices[i] < 0 && this->Others[-1 - this->Simplices[i]].IsEmpty();
  }
  /// Entries of weight 0 are read, unlike in SparseRows. The result of an empty row has no meaning.
  void ForEachBlock(const User& use) const override;
  std::size_t GetMemorySize() const
  {
    return this->Simplices.GetMemorySize() + this->Weights.GetMemorySize() +
      this->Others.GetMemorySize();
  }

  /// The same as Apply for points, in float or double. It completes no rows in memory.
  template <typename Out>
  void Move(const double* points, Out* moved) const;
  /// The same for the rows [begin, end) alone, in this thread.
  template <typename Out>
  void Move(vtkIdType begin, vtkIdType end, const double* points, Out* moved) const;

  /// The same operator without entries of weight 0. It needs less than 2^29 rows, so that offsets
  /// fit in int.
  SparseRows<int> ToSparseRows() const;

private:
  void Complete(vtkIdType i, CornerRow& row) const
  {
    const int simplex = this->Simplices[i];
    if (simplex < 0)
    {
      row = this->Others[-1 - simplex];
      return;
    }
    const int* columns = this->Corners + 4 * static_cast<vtkIdType>(simplex);
    const std::array<double, 4> weights = CompleteWeights(this->Weights.data() + 3 * i);
    for (int k = 0; k < 4; ++k)
    {
      row.Weights[k] = weights[k];
      row.Columns[k] = columns[k];
    }
  }
};

}

#endif
