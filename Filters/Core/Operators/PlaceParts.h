// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceParts.h
 * What is known of the limit at a place of a cell: its value and derivatives.
 */
#ifndef SubdivisionObjects_PlaceParts_h
#define SubdivisionObjects_PlaceParts_h

#include "Core/Memory/Buffer.h"
#include "Core/Operators/PointOperator.h"

#include <array>
#include <utility>

namespace subdivision
{

/// What there is a row of for each place: the value, its derivatives by the parameters, and the
/// second derivatives by the first two of them.
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

/// Over the vertices of a level, a row of each of PlaceParts for each place. All rows of a place
/// have the same columns.
template <typename Id>
struct PlaceRows
{
  PlaceRows() = default;
  /// `offsets`: of the entries of each place. Columns and weights are not set.
  PlaceRows(vtkIdType columns, Buffer<Id>&& offsets)
    : NumberOfColumns(columns)
    , Offsets(std::move(offsets))
    , Columns(this->Offsets[this->Offsets.size() - 1])
  {
    for (Buffer<double>& weights : this->Weights)
    {
      weights = Buffer<double>(this->Columns.size());
    }
  }

  vtkIdType NumberOfColumns = 0;
  Buffer<Id> Offsets; ///< one more than places
  Buffer<Id> Columns;
  std::array<Buffer<double>, PlaceParts::Count> Weights;

  vtkIdType GetNumberOfPlaces() const
  {
    return this->Offsets.empty() ? 0 : this->Offsets.size() - 1;
  }
  /// One of PlaceParts of the places [begin, end). An entry of weight 0 is not read.
  WeightedRows<Id> GetRows(int part, vtkIdType begin, vtkIdType end) const
  {
    WeightedRows<Id> rows{ begin, end - begin, this->Offsets.data() + begin, this->Columns.data(),
      this->Weights[part].data() };
    rows.SkipsZeros = true;
    return rows;
  }
  /// Where the first weight of a place stands in each of PlaceParts.
  std::array<double*, PlaceParts::Count> GetWeights(vtkIdType place)
  {
    std::array<double*, PlaceParts::Count> first{};
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      first[p] = this->Weights[p].data() + this->Offsets[place];
    }
    return first;
  }
};

}

#endif
