// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceSearch.h
 * Newton's method in one cell for the place that is nearest to a point.
 *
 * Steps are damped, as Levenberg and Marquardt do, where the distance changes otherwise than a step
 * promised: beside a hollow, for one, the place lies between two that are nearer. In solids, of
 * which no second derivatives are known, these are learned from the steps (symmetric rank one).
 */
#ifndef SubdivisionObjects_PlaceSearch_h
#define SubdivisionObjects_PlaceSearch_h

#include "Private/Places/NearestPlaces.h"

#include <array>
#include <cstddef>
#include <limits>

namespace subdivision
{

/// The value and derivatives at the place of a search.
using PlaceValue = PlaceValues::value_type;

/// A search in one cell, for one of the points.
struct PlaceSearch
{
  std::size_t Point = 0;
  NearestPlace Place;                                                   ///< where to look next
  NearestPlace Best{ -1, {}, std::numeric_limits<double>::infinity() }; ///< that was looked at
  bool IsDone = false;

  PlaceValue AtBest{};
  /// The second derivatives of half the squared distance minus the derivatives of a linear value,
  /// as far as steps have told.
  std::array<std::array<double, 3>, 3> Bends{};
  double Damping = 0.; ///< 0: the next step is Newton's
  /// Below this there is none. It becomes smaller each time a step without damping went too far:
  /// beside an edge at which a solid is smooth the value nearly stands still in one direction.
  double LeastDamping = 1.;
  double Growth = 2.; ///< of the damping, when a step makes the distance larger
  /// Of a solid, by the corner opposite to each: a first step to a face stops before it.
  std::array<bool, 4> MetFaces{};
  double Promise = 0.; ///< by how much the slope alone would make half the squared distance smaller
};

/// Takes the next step of a search, from the best place that was looked at.
void AdvanceSearch(const SearchedCells& cells, const PlaceValue& value,
  const std::array<double, 3>& target, PlaceSearch& search);

}

#endif
