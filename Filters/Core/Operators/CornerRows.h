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

/// Weights beyond the last corner are 0, their columns those of another corner.
struct CornerRow
{
  double Weights[4] = { 0., 0., 0., 0. };
  int Columns[4] = { 0, 0, 0, 0 };

  bool IsEmpty() const
  {
    return std::all_of(this->Weights, this->Weights + 4, [](double w) { return w == 0.; });
  }
};

struct CornerRows
{
  vtkIdType NumberOfColumns = 0;
  Buffer<CornerRow> Rows;

  vtkIdType GetNumberOfRows() const { return this->Rows.size(); }
  std::size_t GetMemorySize() const { return this->Rows.GetMemorySize(); }

  /// out = S in, for three components. Entries of weight 0 are read, unlike in SparseRows. The
  /// result of an empty row has no meaning.
  template <typename Out>
  void Apply(const double* in, Out* out) const;

  /// The same operator without entries of weight 0. It needs less than 2^29 rows, so that offsets
  /// fit in int.
  SparseRows<int> ToSparseRows() const;
};

}

#endif
