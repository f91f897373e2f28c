// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PackedArrays.h
 * Moves several arrays as one. The values that points and other arrays have at a column lie side by
 * side, in double, so that a row reads each of its columns once, and compilers add several values
 * at a time. Sums have the same terms in the same order as sums of single arrays.
 */
#ifndef SubdivisionObjects_PackedArrays_h
#define SubdivisionObjects_PackedArrays_h

#include "Core/Operators/ApplyRows.h"

#include <vector>

namespace subdivision
{

/// Results may stay side by side for the next operator: then values are copied once before several
/// operators, and the arrays between need no memory.
class PackedArrays
{
public:
  /// Takes the arrays that an operator of `rows` rows moves together, copies their values and lets
  /// go of them: their In becomes null. It takes none where that costs more than it saves: if the
  /// operator does not make many rows of few columns. If it has some from the operator before, it
  /// keeps these, and takes no others.
  void Take(std::vector<MovedArray>& arrays, vtkIdType rows);
  bool IsEmpty() const { return this->Packs.empty(); }
  /// Whether it has the array at this position of the list.
  bool Has(std::size_t place) const;

  /// Results of an operator go to Out of these arrays, the same list, or stay here.
  void Start(const std::vector<MovedArray>& arrays, vtkIdType rows, bool staying);
  /// Applies a block to them; called from many threads.
  void Apply(const RowsView& view);
  /// Lets go of values that are not needed any more.
  void Finish();

private:
  /// How many values lie side by side.
  static constexpr int Lanes = 4;

  struct Pack
  {
    std::vector<MovedArray> Arrays;
    std::vector<std::size_t> Places; ///< in the list
    int Size = 0;                    ///< number of values at a column; the other lanes are 0
    Buffer<double> Values;
    Buffer<double> Results; ///< that stay
  };

  static bool CanBePacked(const MovedArray& array);
  static void Fill(Pack& pack);
  template <typename Rows>
  static void Round(Pack& pack, const Rows& rows);
  template <typename Rows>
  static void SumAndStore(const Pack& pack, const Rows& rows);
  template <typename Id>
  static void Store(
    const Pack& pack, const double* sums, vtkIdType first, const Id* numbers, vtkIdType count);

  std::vector<Pack> Packs;
};

}

#endif
