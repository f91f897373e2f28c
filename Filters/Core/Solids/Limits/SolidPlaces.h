// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidPlaces.h
 * Limits at places in solids, without making a level.
 *
 * The solid is split around the place until the part is so small that the limit is linear between
 * limits of its vertices but for rounding; by the box-spline scheme only until all is regular
 * around the part, where the limit is a polynomial (BoxSplinePatch.h). The weights of the vertices
 * there are then passed from level to level down to the control level (BoxSplineLattice.h,
 * TetOctLattice.h): a place costs some 50 rows for each split, whatever other places there are, and
 * nothing is kept but its own row. Derivatives are as exact as values (PlaceSum.h).
 */
#ifndef SubdivisionObjects_SolidPlaces_h
#define SubdivisionObjects_SolidPlaces_h

#include "Core/Solids/AllSchemes/VolumeSchemes.h"
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

/// The rows of those places in tetrahedra whose surroundings the lattice of the scheme knows the
/// rules of; the others have no columns, such as those beside something semi-sharp.
template <typename Id>
std::vector<SolidRow<Id>> FindSolidRows(const Level<Id>& level, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& places);
/// The same by the tet/oct scheme, in pieces of octahedra too.
template <typename Id>
std::vector<SolidRow<Id>> FindSolidRows(const TetOctLevel<Id>& level,
  const SemiSharpStages<Id>& creases, const std::vector<LimitPlace<Id>>& places);

}

#endif
