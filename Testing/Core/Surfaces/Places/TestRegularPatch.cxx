// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRegularPatch.cxx
 * The polynomials over regular faces: sums, reproduction of linear functions, limits of vertices at
 * corners, derivatives, and what counts as regular.
 */
#include "Core/Surfaces/Places/RegularPatch.h"
#include "SurfaceTools.h"

using namespace surfacetools;

namespace
{

/// A value, its first two derivatives and its second ones: by x twice, by x and y, by y twice.
using LocalJet = std::array<double, 6>;

constexpr int PartsOfJet[6] = { PlaceParts::Value, PlaceParts::First, PlaceParts::First + 1,
  PlaceParts::Second, PlaceParts::Mixed, PlaceParts::SecondOfSecond };

/// Of each control point, by x and y themselves.
std::vector<LocalJet> WeightPoints(PolynomialDomain domain, double x, double y)
{
  PatchParts parts;
  WeightControlPoints(
    domain, { { x, y } }, { { { { 1., 0. } }, { { 0., 1. } } } }, PlaceDerivatives::Second, parts);
  const std::size_t points = domain == PolynomialDomain::Line ? 4
    : domain == PolynomialDomain::Triangle                    ? 12
                                                              : 16;
  std::vector<LocalJet> weights(points);
  for (std::size_t j = 0; j < points; ++j)
  {
    for (std::size_t k = 0; k < 6; ++k)
    {
      weights[j][k] = parts[PartsOfJet[k]][j];
    }
  }
  return weights;
}

/// The value and derivatives of a function that has its control points' values.
LocalJet Evaluate(
  const RegularPatch<int>& patch, double x, double y, const std::function<double(int)>& getValue)
{
  const std::vector<LocalJet> weights = WeightPoints(patch.Domain, x, y);
  LocalJet sum{};
  for (std::size_t j = 0; j < weights.size(); ++j)
  {
    for (const auto& [vertex, weight] : patch.Points[j])
    {
      for (std::size_t k = 0; k < 6; ++k)
      {
        sum[k] += weights[j][k] * weight * getValue(vertex);
      }
    }
  }
  return sum;
}

RegularPatch<int> FindPatch(const Walk& walk, int face)
{
  RegularPatch<int> patch;
  EXPECT_TRUE(patch.FindFace(walk.Level, face)) << face;
  return patch;
}

constexpr double Corners[2][4][2] = { { { 0., 0. }, { 1., 0. }, { 0., 1. } },
  { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } } };

SurfaceSchemeKind GetScheme(bool triangles)
{
  return triangles ? SurfaceSchemeKind::Loop : SurfaceSchemeKind::CatmullClark;
}

}

TEST(RegularPatch, WeightsSumToOneAndDerivativesAreDifferences)
{
  for (const PolynomialDomain domain :
    { PolynomialDomain::Line, PolynomialDomain::Triangle, PolynomialDomain::Quad })
  {
    const double h = 1e-4;
    const double x = 0.31;
    const double y = domain == PolynomialDomain::Line ? 0. : 0.23;
    const auto at = WeightPoints(domain, x, y);
    const auto right = WeightPoints(domain, x + h, y);
    const auto left = WeightPoints(domain, x - h, y);
    const auto up = WeightPoints(domain, x, y + h);
    const auto down = WeightPoints(domain, x, y - h);
    LocalJet sum{};
    for (std::size_t j = 0; j < at.size(); ++j)
    {
      EXPECT_GE(at[j][0], 0.);
      EXPECT_NEAR(at[j][1], (right[j][0] - left[j][0]) / (2. * h), 1e-7) << j;
      EXPECT_NEAR(at[j][2], (up[j][0] - down[j][0]) / (2. * h), 1e-7) << j;
      EXPECT_NEAR(at[j][3], (right[j][1] - left[j][1]) / (2. * h), 1e-7) << j;
      EXPECT_NEAR(at[j][4], (right[j][2] - left[j][2]) / (2. * h), 1e-7) << j;
      EXPECT_NEAR(at[j][5], (up[j][2] - down[j][2]) / (2. * h), 1e-7) << j;
      for (std::size_t k = 0; k < 6; ++k)
      {
        sum[k] += at[j][k];
      }
    }
    EXPECT_NEAR(sum[0], 1., 1e-15);
    for (std::size_t k = 1; k < 6; ++k)
    {
      EXPECT_NEAR(sum[k], 0., 1e-14);
    }
  }
}

/// On a regular grid all faces are regular, also at its border and corners. The limit of a linear
/// function is that function, and the corners of faces have the limits of vertices.
TEST(RegularPatch, GridsAreRegular)
{
  for (const bool triangles : { true, false })
  {
    Walk walk(MakeSheet(4, 4, triangles, { 1., 0., 0. }, { 0., 1., 0. }), GetScheme(triangles));
    const std::vector<Point> flat = walk.Points;
    const std::vector<Point> noise = MakeRandomPoints(flat.size(), 5);
    walk.Points = noise;
    const std::vector<Point> limit = walk.GetLimit();
    const int sides = triangles ? 3 : 4;
    int regular = 0;
    for (int face = 0; face < walk.Level.Mesh.NumberOfFaces; ++face)
    {
      RegularPatch<int> patch;
      if (!patch.FindFace(walk.Level, face))
      {
        EXPECT_TRUE(triangles) << face;
        continue;
      }
      ++regular;
      const int* corners = walk.Level.Mesh.Vertices.data() + sides * face;
      for (int k = 0; k < sides; ++k)
      {
        const double* at = Corners[triangles ? 0 : 1][k];
        for (int c = 0; c < 3; ++c)
        {
          const LocalJet jet = Evaluate(
            patch, at[0], at[1], [&](int v) { return noise[static_cast<std::size_t>(v)][c]; });
          EXPECT_NEAR(jet[0], limit[static_cast<std::size_t>(corners[k])][c], 1e-14) << face;
        }
      }
      const auto linear = [&](int v)
      { return 2. * flat[static_cast<std::size_t>(v)][0] - flat[static_cast<std::size_t>(v)][1]; };
      const LocalJet jet = Evaluate(patch, 0.2, 0.4, linear);
      const double slope = linear(corners[1]) - linear(corners[0]);
      const double other = linear(corners[sides - 1]) - linear(corners[0]);
      EXPECT_NEAR(jet[0], linear(corners[0]) + 0.2 * slope + 0.4 * other, 1e-13) << face;
      EXPECT_NEAR(jet[1], slope, 1e-13) << face;
      EXPECT_NEAR(jet[2], other, 1e-13) << face;
    }
    // Two corners of the triangles' sheet have two triangles each, which is not regular.
    EXPECT_GE(regular, triangles ? 20 : 16);
  }
}

/// The polynomial is the same before and after a step, also on all kinds of borders.
TEST(RegularPatch, StepsDoNotChangeIt)
{
  for (const bool triangles : { true, false })
  {
    Model model = MakeSheet(4, 4, triangles, { 1., 0., 0. }, { 0., 1., 0. });
    model.Points = MakeRandomPoints(model.Points.size(), 8);
    const Walk before(model, GetScheme(triangles));
    Walk walk(model, GetScheme(triangles));
    walk.Step();
    for (int face = 0; face < before.Level.Mesh.NumberOfFaces; ++face)
    {
      RegularPatch<int> patch;
      if (!patch.FindFace(before.Level, face))
      {
        continue;
      }
      const RegularPatch<int> child = FindPatch(walk, 4 * face);
      for (int c = 0; c < 3; ++c)
      {
        const LocalJet coarse = Evaluate(
          patch, 0.1, 0.2, [&](int v) { return before.Points[static_cast<std::size_t>(v)][c]; });
        const LocalJet fine = Evaluate(
          child, 0.2, 0.4, [&](int v) { return walk.Points[static_cast<std::size_t>(v)][c]; });
        EXPECT_NEAR(coarse[0], fine[0], 1e-14) << face;
        EXPECT_NEAR(coarse[1], 2. * fine[1], 1e-13) << face;
        EXPECT_NEAR(coarse[4], 4. * fine[4], 1e-12) << face;
      }
    }
  }
}
