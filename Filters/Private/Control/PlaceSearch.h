// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceSearch.h
 * Newton's method in one cell for the place that is nearest to a point.
 */
#ifndef SubdivisionObjects_PlaceSearch_h
#define SubdivisionObjects_PlaceSearch_h

#include "Private/Control/NearestPlaces.h"

#include <array>
#include <cstddef>
#include <limits>

namespace subdivision
{

/// A search in one cell, for one of the points.
struct PlaceSearch
{
  std::size_t Point = 0;
  NearestPlace Place;                                                   ///< where to look next
  NearestPlace Best{ -1, {}, std::numeric_limits<double>::infinity() }; ///< that was looked at
  bool IsDone = false;
};

/// What is known of the place of a search: its value and derivatives.
using PlaceValue = PlaceValues::value_type;

/// Takes the next step of a search, or goes back if the last one made the distance larger.
void AdvanceSearch(const SearchedCells& cells, const PlaceValue& value,
  const std::array<double, 3>& target, PlaceSearch& search);

}

#endif
