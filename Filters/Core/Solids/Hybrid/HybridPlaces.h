// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridPlaces.h
 * Limits at any place of a cell of a level in which every cell keeps its type, with derivatives
 * (Mathematics 8, 15).
 *
 * The cell and the cells around it are split, and the child with the place is looked at with the
 * cells around it, until the limit over it is a polynomial (over lines, quads, triangles and
 * hexahedra with regular surroundings), or the child is so small that the limit is linear between
 * its corners but for rounding. The weights go back from level to level (PlaceSum.h). What lies
 * around a child is the same again and again: rows of each such patch are made once, and a place
 * costs a sum for each split.
 */
#ifndef SubdivisionObjects_HybridPlaces_h
#define SubdivisionObjects_HybridPlaces_h

#include "Core/Cells/CellFrames.h"
#include "Core/Operators/PlaceParts.h"
#include "Core/Solids/Hybrid/HybridLevel.h"

#include <array>
#include <memory>
#include <vector>

namespace subdivision
{

struct HybridPlace
{
  vtkIdType Cell = 0;                     ///< of the level, no twin
  FramePoint At{};                        ///< in the coordinates of CellFrames.h
  std::array<FramePoint, 3> Directions{}; ///< how these change with each parameter
};

/// The limits of a level, which must live as long.
template <typename Id>
class HybridPlaceLimits
{
public:
  explicit HybridPlaceLimits(const HybridLevel<Id>& level);
  PlaceRows<Id> Find(const std::vector<HybridPlace>& places, PlaceDerivatives derivatives);

private:
  struct Finders;
  const std::shared_ptr<Finders> OfThreads;
};

}

#endif
