// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestShadingNormals.cxx
 * Normals of points without tangent plane: unit vectors that do not depend on the order of calls.
 */
#include "Core/Operators/ShadingNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace subdivision;

namespace
{

using Vector = std::array<double, 3>;
using Triangle = std::array<vtkIdType, 3>;
using Line = std::array<vtkIdType, 2>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The normal of point 0 by its triangles and lines.
Vector Find(const std::vector<Vector>& points, const std::vector<Triangle>& triangles,
  const std::vector<Line>& lines = {})
{
  Buffer<unsigned char> missing(static_cast<vtkIdType>(points.size()), 0);
  missing[0] = 1;
  std::vector<Vector> normals(points.size(), Vector{ 0., 0., 0. });
  ShadingNormals shading(points[0].data(), missing, normals[0].data());
  for (const Triangle& triangle : triangles)
  {
    shading.AddFacet(triangle.data(), 3, false);
  }
  for (const Line& line : lines)
  {
    shading.AddLine(line[0], line[1]);
  }
  shading.AddPoint(0);
  shading.Fill();
  EXPECT_NEAR(Dot(normals[0], normals[0]), 1., 1e-14);
  return normals[0];
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

TEST(ShadingNormals, DoNotDependOnTheOrderOfFacets)
{
  const std::vector<Vector> points = MakePoints();
  std::vector<Triangle> triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 5, 6 },
    { 0, 7, 8 }, { 0, 1, 8 } };
  const Vector expected = Find(points, triangles);
  std::mt19937 chance(3);
  for (int i = 0; i < 50; ++i)
  {
    std::shuffle(triangles.begin(), triangles.end(), chance);
    EXPECT_EQ(Find(points, triangles), expected);
  }
}

TEST(ShadingNormals, OfFacetsThatCancelAreThoseOfTheLargest)
{
  const std::vector<Vector> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const Vector up = Find(points, { { 0, 1, 2 }, { 0, 2, 1 } });
  EXPECT_EQ(up, Find(points, { { 0, 2, 1 }, { 0, 1, 2 } }));
  EXPECT_EQ(up, (Vector{ 0., 0., 1. }));
}

TEST(ShadingNormals, OfCurvesArePerpendicularToTheirTangent)
{
  const std::vector<Vector> points = MakePoints();
  const Vector normal = Find(points, {}, { { 1, 0 }, { 0, 2 } });
  Vector chord;
  std::transform(
    points[1].begin(), points[1].end(), points[2].begin(), chord.begin(), std::minus<>());
  EXPECT_NEAR(Dot(normal, chord), 0., 1e-14);
  EXPECT_EQ(normal, Find(points, {}, { { 2, 0 }, { 0, 1 } }));
  EXPECT_EQ(normal, Find(points, {}, { { 2, 0 }, { 0, 1 }, { 1, 0 } }))
    << "a line that is there twice";
  std::vector<Line> star = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 4, 0 } };
  const Vector ofStar = Find(points, {}, star);
  std::reverse(star.begin(), star.end());
  EXPECT_EQ(Find(points, {}, star), ofStar);
}

TEST(ShadingNormals, AreNeverZero)
{
  const double nan = std::nan("");
  const Vector z = { 0., 0., 1. };
  EXPECT_EQ(Find({ { 1, 2, 3 } }, {}), z);
  const std::vector<Vector> same(4, Vector{ 1., 1., 1. });
  EXPECT_EQ(Find(same, { { 0, 1, 2 } }, { { 0, 3 } }), z);
  const std::vector<Vector> straight = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } };
  EXPECT_EQ(Find(straight, { { 0, 1, 2 } })[2], 1.);
  EXPECT_NEAR(Find(straight, { { 0, 1, 2 } }, { { 0, 3 } })[0], 0., 1e-15);
  EXPECT_EQ(Find({ { 0, 0, 0 }, { nan, 0, 0 } }, {}, { { 0, 1 } }), z);
}
