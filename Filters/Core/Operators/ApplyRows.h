// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ApplyRows.h
 * Applies operators to arrays. ApplyRows.cxx alone knows the types of values that arrays have.
 */
#ifndef SubdivisionObjects_ApplyRows_h
#define SubdivisionObjects_ApplyRows_h

#include "Core/Operators/PointOperator.h"

#include <memory>
#include <vector>

namespace subdivision
{

/// An array of interleaved values, and where its values after the operator go. Types are numbers of
/// VTK, such as VTK_FLOAT. They are equal, or values in double become values in float.
struct MovedArray
{
  const void* In;
  int InType;
  void* Out;
  int OutType;
  int Components;
  /// Number of values of In, each of `Components` numbers: at least one for each column, but rows
  /// of a part of a mesh may read values of more points. 0: it is not known.
  vtkIdType Tuples = 0;
  /// The owner of In, if nobody else keeps it. It is let go as soon as its values are not needed,
  /// which may be before the values of Out take memory.
  std::shared_ptr<const void> Owner = nullptr;
};

class PackedArrays;

/// Applies an operator to all arrays in one pass, so that each row is made or read only once. Each
/// block goes to `also` too, if it is not empty. An operator with values between makes a pass for
/// each array, so that only one array has such values at a time, and `also` must be empty. So it
/// must be for an operator of chains.
void ApplyToArrays(const PointOperator& operation, std::vector<MovedArray> arrays,
  const PointOperator::User& also = PointOperator::User());

/// The same for operators one after the other, that have neither chains nor values between:
/// `packed` was told to start with these arrays, and has the values that stay side by side.
void ApplyToArrays(const PointOperator& operation, PackedArrays& packed,
  std::vector<MovedArray> arrays, const PointOperator::User& also = PointOperator::User());

/// Values of any type in double: they themselves if they are, else `converted`.
const double* ReadDoubles(const void* in, int type, vtkIdType size, Buffer<double>& converted);
/// Stores values as results of operators are: integers are rounded and stay in range, and a finite
/// number never becomes infinite.
void StoreDoubles(const double* in, void* out, int type, vtkIdType size);

/// Applies one block to values in double. `out` points to row 0, or to the first value between
/// where the rows go there.
void SumRows(const RowsView& rows, const double* in, double* out, int components);

}

#endif
