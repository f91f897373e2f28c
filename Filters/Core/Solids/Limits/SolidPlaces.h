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

#include "Core/Memory/UnevenRanges.h"
#include "Core/Operators/PlaceSum.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Core/Solids/Limits/SharpLattice.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace subdivision
{

/// How often a simplex is split around a place that lies in no polynomial. The limit is linear over
/// a part as small as this but for rounding, which does not grow with the splits (PlaceSum).
constexpr int MostSplits = 52;

/// The rows of those places that are in tetrahedra; the others have no columns.
template <typename Id>
std::vector<PlaceRow<Id>> FindSolidRows(const Level<Id>& level,
  const LevelLattices<Level<Id>>& lattices, const std::vector<LimitPlace<Id>>& places);
/// The same by the tet/oct scheme, in pieces of octahedra too.
template <typename Id>
std::vector<PlaceRow<Id>> FindSolidRows(const TetOctLevel<Id>& level,
  const LevelLattices<TetOctLevel<Id>>& lattices, const std::vector<LimitPlace<Id>>& places);

/// act(finder, number of the place) for all places in threads, each of which makes a finder.
template <typename Make, typename Act>
void ForPlacesInThreads(std::size_t places, const Make& make, const Act& act)
{
  vtkSMPThreadLocal<decltype(make())> ofThreads;
  ForUnevenRanges(static_cast<vtkIdType>(places),
    [&](vtkIdType begin, vtkIdType end)
    {
      auto& finder = ofThreads.Local();
      if (!finder)
      {
        finder = make();
      }
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        act(*finder, i);
      }
    });
}

}

#endif
