// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceParts.h
 * What is known of the limit at a place of a cell: its value and derivatives.
 */
#ifndef SubdivisionObjects_PlaceParts_h
#define SubdivisionObjects_PlaceParts_h

#include "Core/Operators/SparseRows.h"

#include <array>

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

/// Over the vertices of a level, one row for each place; all have the same columns.
template <typename Id>
using PlaceRows = std::array<SparseRows<Id>, PlaceParts::Count>;

}

#endif
