// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellFrames.h
 * Coordinates of places in cells of all types, and of their corners and children.
 *
 * The unit interval, square and cube; in triangles, tetrahedra and, with a third coordinate along
 * the axis, wedges the weights of the corners but the first; pyramids stand on the unit square with
 * the apex over its first corner; the diagonals of octahedra go from -1 to 1. So children are
 * affine images, and their corners are exact.
 */
#ifndef SubdivisionObjects_CellFrames_h
#define SubdivisionObjects_CellFrames_h

#include "Core/Cells/CellShapes.h"

#include <array>
#include <vector>

namespace subdivision
{

using FramePoint = std::array<double, 3>;

/// Where the corners of a cell are in its own coordinates.
std::vector<FramePoint> GetFrameCorners(CellShape shape);
/// And those of a child, in any coordinates in which those of its cell are given.
std::vector<FramePoint> GetChildCorners(
  CellShape shape, const std::vector<FramePoint>& corners, const CellChild& child);

/// How much corners count at a place, and how that changes along the coordinates.
struct CornerShares
{
  std::array<double, 8> Values{};
  std::array<FramePoint, 8> Slopes{};
  double Least = 0.; ///< not negative in the cell
};
/// The shares in a function that is linear in each simplex of a cut of the cell.
CornerShares ShareCorners(
  CellShape shape, const std::vector<FramePoint>& corners, const FramePoint& place);

}

#endif
