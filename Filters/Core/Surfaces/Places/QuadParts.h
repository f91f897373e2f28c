// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QuadParts.h
 * The four parts of a quad after a step, each of which begins at a corner.
 */
#ifndef SubdivisionObjects_QuadParts_h
#define SubdivisionObjects_QuadParts_h

#include "Core/Surfaces/Places/SurfacePlaces.h"

#include <array>

namespace subdivision
{

/// How x and y of the part at a corner lie in the quad: x is along the edge that begins at the
/// corner, y along the one before.
struct QuadCorner
{
  int Axes[2];    ///< of the quad
  bool Turned[2]; ///< whether they run against these
};
constexpr QuadCorner QuadCorners[4] = { { { 0, 1 }, { false, false } },
  { { 1, 0 }, { false, true } }, { { 0, 1 }, { true, true } }, { { 1, 0 }, { true, false } } };

/// A place of a quad as one of the part at its corner k.
template <typename Id>
void GoToCornerOfQuad(int k, SurfacePlace<Id>& place)
{
  const std::array<double, 2> at = place.At;
  const auto directions = place.Directions;
  const QuadCorner& corner = QuadCorners[k];
  for (int i = 0; i < 2; ++i)
  {
    const int axis = corner.Axes[i];
    place.At[i] = 2. * (corner.Turned[i] ? 1. - at[axis] : at[axis]);
    for (int p = 0; p < 2; ++p)
    {
      place.Directions[i][p] = (corner.Turned[i] ? -2. : 2.) * directions[axis][p];
    }
  }
}

/// A place of the part at corner k as one of the quad.
template <typename Id>
void LeaveCornerOfQuad(int k, SurfacePlace<Id>& place)
{
  const std::array<double, 2> at = place.At;
  const auto directions = place.Directions;
  const QuadCorner& corner = QuadCorners[k];
  for (int i = 0; i < 2; ++i)
  {
    const int axis = corner.Axes[i];
    place.At[axis] = corner.Turned[i] ? 1. - 0.5 * at[i] : 0.5 * at[i];
    for (int p = 0; p < 2; ++p)
    {
      place.Directions[axis][p] = (corner.Turned[i] ? -0.5 : 0.5) * directions[i][p];
    }
  }
}

}

#endif
