// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PackedArrays.h
 * Moves several arrays as one. The values that points and other arrays have at a column lie side by
 * side, in double, so that a row reads each of its columns once, and compilers add several values
 * at a time. Sums have the same terms in the same order as those of single arrays.
 */
#ifndef SubdivisionObjects_PackedArrays_h
#define SubdivisionObjects_PackedArrays_h

#include "Core/Operators/ApplyRows.h"

#include <vector>

namespace subdivision
{

class PackedArrays
{
public:
  /// Takes from `arrays` those that are moved together, copies their values, and lets go of them.
  /// It takes none where that costs more than it saves: if an operator does not make many rows of
  /// few columns.
  PackedArrays(const PointOperator& operation, std::vector<MovedArray>& arrays);

  /// Applies a block to them.
  void Apply(const RowsView& view) const;

private:
  /// How many values lie side by side.
  static constexpr int Lanes = 4;

  struct Pack
  {
    std::vector<MovedArray> Arrays;
    int Size = 0; ///< number of values at a column; the other lanes are 0
    Buffer<double> Values;
  };

  static bool CanBePacked(const MovedArray& array, vtkIdType rows);
  static void Fill(Pack& pack);
  template <typename Id>
  static void Store(
    const Pack& pack, const double* sums, vtkIdType first, const Id* numbers, vtkIdType count);

  std::vector<Pack> Packs;
};

}

#endif
