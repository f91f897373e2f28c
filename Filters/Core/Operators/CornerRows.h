// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CornerRows.h
 * An operator all of whose rows are means of the corners of a simplex. Nearly all have four: no
 * offsets, and a loop whose length is known, so that a row costs little more than to read it.
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

  /// out = S in, for three components. Unlike those of SparseRows, entries of weight 0 are read:
  /// what an empty row gives means nothing.
  template <typename Out>
  void Apply(const double* in, Out* out) const;

  /// The same without entries of weight 0; there are less than 2^29 rows.
  SparseRows<int> ToSparseRows() const;
};

}

#endif
