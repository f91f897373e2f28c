// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellFrames.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Cells as simplices.
const std::vector<std::vector<unsigned char>>& GetSimplices(CellShape shape)
{
  static const std::vector<std::vector<unsigned char>> all[NumberOfShapes] = { { { 0 } },
    { { 0, 1 } }, { { 0, 1, 2 } }, { { 0, 1, 2 }, { 0, 2, 3 } }, { { 0, 1, 2, 3 } },
    { { 0, 1, 2, 4 }, { 0, 2, 3, 4 } }, { { 0, 1, 2, 5 }, { 0, 1, 5, 4 }, { 0, 4, 5, 3 } },
    { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 }, { 0, 7, 4, 6 }, { 0, 4, 5, 6 },
      { 0, 5, 1, 6 } },
    { { 0, 1, 2, 4 }, { 0, 1, 4, 3 }, { 0, 1, 3, 5 }, { 0, 1, 5, 2 } } };
  return all[static_cast<std::size_t>(shape)];
}

FramePoint Subtract(const FramePoint& a, const FramePoint& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// Axes that a simplex does not have are axes of the coordinates.
CornerShares ShareSimplex(const std::vector<unsigned char>& simplex,
  const std::vector<FramePoint>& corners, const FramePoint& place)
{
  std::array<FramePoint, 3> axes{ { { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { 0., 0., 1. } } } };
  const FramePoint& origin = corners[simplex[0]];
  const FramePoint x = Subtract(place, origin);
  for (std::size_t a = 0; a + 1 < simplex.size(); ++a)
  {
    axes[a] = Subtract(corners[simplex[a + 1]], origin);
  }
  CornerShares shares;
  double rest = 1.;
  shares.Least = 1.;
  for (std::size_t a = 0; a + 1 < simplex.size(); ++a)
  {
    const FramePoint& b = axes[(a + 1) % 3];
    const FramePoint& c = axes[(a + 2) % 3];
    const FramePoint cross{ { b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2],
      b[0] * c[1] - b[1] * c[0] } };
    const double volume = cross[0] * axes[a][0] + cross[1] * axes[a][1] + cross[2] * axes[a][2];
    for (std::size_t k = 0; k < 3; ++k)
    {
      shares.Slopes[simplex[a + 1]][k] = cross[k] / volume;
      shares.Slopes[simplex[0]][k] -= cross[k] / volume;
      shares.Values[simplex[a + 1]] += cross[k] / volume * x[k];
    }
    rest -= shares.Values[simplex[a + 1]];
    shares.Least = std::min(shares.Least, shares.Values[simplex[a + 1]]);
  }
  shares.Values[simplex[0]] = rest;
  shares.Least = std::min(shares.Least, rest);
  return shares;
}

}

std::vector<FramePoint> GetFrameCorners(CellShape shape)
{
  const std::vector<FramePoint> cube{ { { 0., 0., 0. } }, { { 1., 0., 0. } }, { { 1., 1., 0. } },
    { { 0., 1., 0. } }, { { 0., 0., 1. } }, { { 1., 0., 1. } }, { { 1., 1., 1. } },
    { { 0., 1., 1. } } };
  const auto pick = [&cube](std::initializer_list<std::size_t> corners)
  {
    std::vector<FramePoint> picked;
    for (const std::size_t corner : corners)
    {
      picked.push_back(cube[corner]);
    }
    return picked;
  };
  switch (shape)
  {
    case CellShape::Quad:
      return pick({ 0, 1, 2, 3 });
    case CellShape::Pyramid:
      return pick({ 0, 1, 2, 3, 4 });
    case CellShape::Wedge:
      return pick({ 0, 1, 3, 4, 5, 7 });
    case CellShape::Hex:
      return cube;
    case CellShape::Octahedron:
      return { { { -1., 0., 0. } }, { { 1., 0., 0. } }, { { 0., -1., 0. } }, { { 0., 1., 0. } },
        { { 0., 0., -1. } }, { { 0., 0., 1. } } };
    default:
    {
      const std::vector<FramePoint> tet = pick({ 0, 1, 3, 4 });
      return { tet.begin(), tet.begin() + GetCellTable(shape).Corners };
    }
  }
}

std::vector<FramePoint> GetChildCorners(
  CellShape shape, const std::vector<FramePoint>& corners, const CellChild& child)
{
  std::vector<FramePoint> all(static_cast<std::size_t>(GetCellTable(child.Shape).Corners));
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const std::vector<unsigned char>& of = GetCellTable(shape).PointCorners[child.Points[i]];
    // The middle of an octahedron is the mean of two opposite corners: a sixth would be rounded.
    const std::size_t size = of.size() == 6 ? 2 : of.size();
    for (std::size_t k = 0; k < 3 * size; ++k)
    {
      all[i][k % 3] += corners[of[k / 3]][k % 3] / static_cast<double>(size);
    }
  }
  return all;
}

CornerShares ShareCorners(
  CellShape shape, const std::vector<FramePoint>& corners, const FramePoint& place)
{
  CornerShares best;
  best.Least = -1.e300;
  for (const std::vector<unsigned char>& simplex : GetSimplices(shape))
  {
    const CornerShares shares = ShareSimplex(simplex, corners, place);
    best = shares.Least > best.Least ? shares : best;
  }
  return best;
}

}
