// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidPlaces.h
 * Limits at places of tetrahedra by the box-spline scheme, without making a level.
 *
 * The tetrahedron is split around the place until all is regular around the part, where the limit
 * is a polynomial (BoxSplinePatch.h), or until the part is so small that a polynomial between
 * limits of its vertices is the limit but for rounding. The weights of these vertices are then
 * passed from level to level down to the control level (SolidLattice.h): a place costs some 50
 * rows for each split, whatever other places there are, and nothing is kept but its own row.
 */
#ifndef SubdivisionObjects_SolidPlaces_h
#define SubdivisionObjects_SolidPlaces_h

#include "Core/Solids/Limits/PlaceLimits.h"

#include <array>
#include <vector>

namespace subdivision
{

/// The rows of a place (PlaceParts), with ascending columns.
template <typename Id>
struct SolidRow
{
  std::vector<Id> Columns;
  std::vector<std::array<double, PlaceParts::Count>> Weights; ///< of each column
};

/// The rows of those places in tetrahedra whose surroundings SolidLattice knows the rules of; the
/// others have no columns. Nothing may be semi-sharp.
template <typename Id>
std::vector<SolidRow<Id>> FindSolidRows(
  const Level<Id>& level, const std::vector<LimitPlace<Id>>& places);

}

#endif
