// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestShadingNormals.cxx
 * Normals of points without tangent plane: unit vectors that do not depend on the order of calls.
 */
#include "PointTools.h"

#include "Core/Operators/ShadingNormals.h"

using namespace subdivision;
using namespace point_tools;

namespace
{

using Vector = std::array<double, 3>;
using Corner = std::array<int, 2>;

/// The normal of the origin, from triangles to two of the points each and from lines to points.
Vector Find(const std::vector<Vector>& points, const std::vector<Corner>& corners,
  const std::vector<int>& lines = {})
{
  ShadingStar star;
  for (const auto& [a, b] : corners)
  {
    Vector middle;
    for (int c = 0; c < 3; ++c)
    {
      middle[c] = (points[a][c] + points[b][c]) / 3.;
    }
    star.AddCorner(points[a].data(), points[b].data(), middle.data(), 1.);
  }
  for (const int line : lines)
  {
    star.AddLine(points[line].data());
  }
  Vector normal = { 0., 0., 0. };
  star.FindNormal(normal.data());
  EXPECT_NEAR(Dot(normal, normal), 1., 1e-14);
  return normal;
}

std::vector<Vector> MakePoints()
{
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> value(-1., 1.);
  std::vector<Vector> points;
  for (int i = 0; i < 9; ++i)
  {
    points.push_back({ value(chance), value(chance), value(chance) });
  }
  return points;
}

}

TEST(ShadingNormals, DoNotDependOnTheOrderOfCorners)
{
  const std::vector<Vector> points = MakePoints();
  std::vector<Corner> corners = { { 1, 2 }, { 2, 3 }, { 3, 4 }, { 5, 6 }, { 7, 8 }, { 1, 8 } };
  const Vector expected = Find(points, corners);
  std::mt19937 chance(3);
  for (int i = 0; i < 50; ++i)
  {
    std::shuffle(corners.begin(), corners.end(), chance);
    EXPECT_EQ(Find(points, corners), expected);
  }
}

TEST(ShadingNormals, CountAngles)
{
  // A right angle up and one half as large to the side, whatever the lengths.
  const double root = std::sqrt(0.5);
  const Vector normal =
    Find({ { 9, 0, 0 }, { 0, 0.1, 0 }, { 0, root, root } }, { { 0, 1 }, { 1, 2 } });
  EXPECT_NEAR(normal[2] / normal[0], 2., 1e-12);
  EXPECT_NEAR(normal[1], 0., 1e-15);
}

TEST(ShadingNormals, OfCornersThatCancelAreThoseOfTheAreas)
{
  const std::vector<Vector> points = { { 1, 0, 0 }, { 0, 1, 0 }, { 3, 0, 0 }, { 0, 0, 2 } };
  const Vector up = Find(points, { { 0, 1 }, { 1, 0 } });
  EXPECT_EQ(up, Find(points, { { 1, 0 }, { 0, 1 } }));
  EXPECT_EQ(up, (Vector{ 0., 0., 1. }));
  EXPECT_EQ(Find(points, { { 0, 1 }, { 1, 2 } }), (Vector{ 0., 0., -1. })) << "2 is farther away";
  // Two quads with the same sides: their middles tell them apart.
  ShadingStar star;
  star.AddCorner(points[0].data(), points[1].data(), points[2].data(), 1.);
  star.AddCorner(points[1].data(), points[0].data(), points[3].data(), 1.);
  Vector normal;
  star.FindNormal(normal.data());
  EXPECT_GT(std::abs(normal[0]), 0.1);
}

TEST(ShadingNormals, OfCornersWithSidesInOneLineAreThoseOfTheFace)
{
  ShadingStar star;
  const Vector a = { 1, 0, 0 };
  const Vector b = { -1, 0, 0 };
  const Vector middle = { 0, 1, 0 };
  star.AddCorner(a.data(), b.data(), middle.data(), 1.);
  Vector normal;
  star.FindNormal(normal.data());
  EXPECT_EQ(normal, (Vector{ 0., 0., 1. }));
}

TEST(ShadingNormals, OfCurvesArePerpendicularToTheirTangent)
{
  const std::vector<Vector> points = MakePoints();
  const Vector normal = Find(points, {}, { 1, 2 });
  Vector chord;
  std::transform(
    points[1].begin(), points[1].end(), points[2].begin(), chord.begin(), std::minus<>());
  EXPECT_NEAR(Dot(normal, chord), 0., 1e-14);
  EXPECT_EQ(normal, Find(points, {}, { 2, 1 }));
  EXPECT_EQ(normal, Find(points, {}, { 2, 1, 1 })) << "a line that is there twice";
  EXPECT_EQ(Find(points, {}, { 1, 2, 3, 4 }), Find(points, {}, { 4, 2, 3, 1 }));
}

TEST(ShadingNormals, AreNeverZero)
{
  const Vector z = { 0., 0., 1. };
  EXPECT_EQ(Find({}, {}), z);
  const std::vector<Vector> same(4, Vector{ 0., 0., 0. });
  EXPECT_EQ(Find(same, { { 1, 2 } }, { 3 }), z);
  const std::vector<Vector> straight = { { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } };
  EXPECT_NEAR(Find(straight, { { 0, 1 } }, { 2 })[0], 0., 1e-15);
  EXPECT_EQ(Find({ { std::nan(""), 0, 0 } }, {}, { 0 }), z);
}

/// The local matrix of a curve: from any level the star is that of one and the same level.
TEST(ShadingNormals, StarsAreThoseOfOneLevel)
{
  const std::vector<double> curve = { 3. / 4, 1. / 8, 1. / 8, 1. / 2, 1. / 2, 0., 1. / 2, 0.,
    1. / 2 };
  const auto apply = [](const std::vector<double>& rows, const std::vector<double>& values)
  {
    std::vector<double> result(rows.size() / 3, 0.);
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      result[i / 3] += rows[i] * values[i % 3];
    }
    return result;
  };
  std::vector<double> values = { 0.3, 1., -0.7 };
  const std::vector<double> expected = apply(FindStarRows(curve, 3, {}, 0), values);
  EXPECT_NEAR(expected[0] + expected[1], 0., 1e-20) << "a curve goes on straight";
  for (int made = 1; made < 8; ++made)
  {
    values = apply(curve, values);
    const std::vector<double> star = apply(FindStarRows(curve, 3, {}, made), values);
    EXPECT_NEAR(star[0] / expected[0], 1., 1e-12) << made;
  }
}
