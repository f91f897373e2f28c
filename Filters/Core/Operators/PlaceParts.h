// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceParts.h
 * The rows of the limit at a place of a cell: its value and derivatives.
 */
#ifndef SubdivisionObjects_PlaceParts_h
#define SubdivisionObjects_PlaceParts_h

#include "Core/Memory/Buffer.h"
#include "Core/Operators/PointOperator.h"

#include <array>
#include <utility>

namespace subdivision
{

/// The rows of each place: the value, its derivatives by the parameters, and the second derivatives
/// by the first two parameters.
struct PlaceParts
{
  enum : int
  {
    Value,
    First, ///< and two more
    Second = First + 3,
    Mixed,
    SecondOfSecond,
    Count
  };
};

/// Up to which derivatives something is wanted: each of PlaceParts takes as much memory as any
/// other.
enum class PlaceDerivatives
{
  None,
  First,
  Second
};
constexpr bool IsWanted(int part, PlaceDerivatives derivatives)
{
  return part == PlaceParts::Value ||
    derivatives >= (part < PlaceParts::Second ? PlaceDerivatives::First : PlaceDerivatives::Second);
}

/// Of each of PlaceParts, where its first number stands. Null: it is not wanted.
using PlaceSums = std::array<double*, PlaceParts::Count>;

/// Over the vertices of a level, a row of each of PlaceParts for each place. All rows of a place
/// have the same columns.
template <typename Id>
struct PlaceRows
{
  PlaceRows() = default;
  /// `offsets`: of the entries of each place. `dimension`: the largest of the cells with places;
  /// without solids there is no derivative by a third parameter. Columns and weights are not set.
  PlaceRows(vtkIdType columns, Buffer<Id>&& offsets, int dimension, PlaceDerivatives derivatives)
    : NumberOfColumns(columns)
    , Offsets(std::move(offsets))
    , Columns(this->Offsets[this->Offsets.size() - 1])
  {
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      if (IsWanted(p, derivatives) && (p != PlaceParts::First + 2 || dimension == 3))
      {
        this->Weights[p] = Buffer<double>(this->Columns.size());
      }
    }
  }

  vtkIdType NumberOfColumns = 0;
  Buffer<Id> Offsets; ///< one more than places
  Buffer<Id> Columns;
  std::array<Buffer<double>, PlaceParts::Count> Weights; ///< empty: not there, see HasPart

  vtkIdType GetNumberOfPlaces() const
  {
    return this->Offsets.empty() ? 0 : this->Offsets.size() - 1;
  }
  /// Whether there are rows of one of PlaceParts. Other parts were not wanted, or are zero.
  bool HasPart(int part) const { return !this->Weights[part].empty(); }
  /// One of PlaceParts that is there, of the places [begin, end). An entry of weight 0 is not read.
  WeightedRows<Id> GetRows(int part, vtkIdType begin, vtkIdType end) const
  {
    WeightedRows<Id> rows{ begin, end - begin, this->Offsets.data() + begin, this->Columns.data(),
      this->Weights[part].data() };
    rows.SkipsZeros = true;
    return rows;
  }
  /// Where the first weight of a place stands in each of PlaceParts.
  PlaceSums GetWeights(vtkIdType place)
  {
    PlaceSums first{};
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      first[p] = this->HasPart(p) ? this->Weights[p].data() + this->Offsets[place] : nullptr;
    }
    return first;
  }
};

}

#endif
