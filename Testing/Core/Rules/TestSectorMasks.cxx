// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: the weights of sectors, against what they are made for.
#include "Precompiled.h"

#include "Core/Rules/SectorMasks.h"

using namespace subdivision;

TEST(SectorMasks, AFarEndHasThePlainWeightInARegularSector)
{
  EXPECT_NEAR(GetFarEndWeight(Pi / 3.), PlainEndWeight, 1e-15);
  EXPECT_NEAR(GetFarEndWeight(Pi / 2.), 1. / 2., 1e-15);
  EXPECT_NEAR(GetFarEndWeight(Pi), 3. / 4., 1e-15);
}

TEST(SectorMasks, AnglesStayAwayFromTheDegenerateOnes)
{
  EXPECT_EQ(ClampCornerAngle(0.01 * Pi, 0.), Pi / 8.);
  EXPECT_EQ(ClampCornerAngle(0.2 * Pi, 0.), 0.2 * Pi);
  EXPECT_EQ(ClampCornerAngle(0.8 * Pi, 0.), 0.8 * Pi);
  EXPECT_EQ(ClampCornerAngle(0.95 * Pi, 0.), 7. * Pi / 8.);
  EXPECT_EQ(ClampCornerAngle(Pi, 0.), 9. * Pi / 8.);
  EXPECT_EQ(ClampCornerAngle(1.05 * Pi, 0.), 9. * Pi / 8.);
  EXPECT_EQ(ClampCornerAngle(1.2 * Pi, 0.), 1.2 * Pi);
  EXPECT_EQ(ClampCornerAngle(1.8 * Pi, 0.), 1.8 * Pi);
  EXPECT_EQ(ClampCornerAngle(1.95 * Pi, 0.), 15. * Pi / 8.);
  // What is nearly straight is convex.
  EXPECT_EQ(ClampCornerAngle(1.005 * Pi, 0.01), 7. * Pi / 8.);
  EXPECT_EQ(ClampCornerAngle(1.015 * Pi, 0.01), 9. * Pi / 8.);
}

TEST(SectorMasks, FlatnessMakesTheThirdEigenvalueAQuarter)
{
  EXPECT_NEAR(GetThirdEigenvalueOfTriangles(2, Pi), 0.5, 1e-15);
  EXPECT_NEAR(GetThirdEigenvalueOfTriangles(2, 3. * Pi / 2.), 0.5 + std::sqrt(2.) / 8., 1e-15);
  EXPECT_NEAR(GetThirdEigenvalueOfTriangles(3, Pi / 2.), 0.625 - std::sqrt(3.) / 8., 1e-15);
  for (double third : { 0.26, 0.5, 0.7 })
  {
    EXPECT_NEAR((1. - GetFlatness(third)) * third, 0.25, 1e-15);
  }
  EXPECT_EQ(GetFlatness(0.25), 0.);
  EXPECT_EQ(GetFlatness(0.2), 0.);
}

/// The plane of the two edges, one of which is the first axis: points with the weights lie half as
/// far from the corner as in the characteristic map.
TEST(SectorMasks, FlatWeightsArePlacesInThePlaneOfTheEdges)
{
  for (double angle : { 0.5, 2.5, 4., 5.5 })
  {
    for (double turn : { 0., 0.7, 2. })
    {
      const double c = 0.8 * std::cos(turn);
      const double s = 0.8 * std::sin(turn);
      const FlatWeights weights = GetFlatWeights(angle, c, s);
      EXPECT_NEAR(weights.First + weights.Last * std::cos(angle), c / 2., 1e-15);
      EXPECT_NEAR(weights.Last * std::sin(angle), s / 2., 1e-15);
    }
  }
}

namespace
{

/// The weights that a step gives to the points of before, in the sum of the new points with the
/// weights of a mask: of the vertex, of one end, of the inner edge j and of the face before it.
struct Sums
{
  double Own;
  double End;
  std::vector<double> Edges; ///< 1 to k - 1
  std::vector<double> Faces; ///< j lies between edges j and j + 1
};

Sums ApplyStep(const TransversalMask& mask, int k, bool quads, double gamma)
{
  auto edge = [&](int j) { return std::sin(j * Pi / k); };
  auto face = [&](int j) { return mask.Faces * (edge(j) + edge(j + 1)); };
  const double beside = quads ? 1. / 16. : 1. / 8.; // of an edge point: the next edges
  Sums sums{ 3. / 4. * mask.Own + mask.End, 0., {}, {} };
  sums.End = mask.End / 2. + mask.Own / 8. + beside * edge(1) + face(0) / 4.;
  for (int j = 1; j < k; ++j)
  {
    sums.Own += (0.75 - gamma) * edge(j);
    sums.Edges.push_back(
      gamma * edge(j) + beside * (edge(j - 1) + edge(j + 1)) + (face(j - 1) + face(j)) / 4.);
  }
  for (int j = 0; j < k; ++j)
  {
    sums.Own += face(j) / 4.;
    sums.Faces.push_back(face(j) / 4. + (quads ? (edge(j) + edge(j + 1)) / 16. : 0.));
  }
  return sums;
}

}

TEST(SectorMasks, ATransversalMaskIsALeftEigenvector)
{
  for (int k = 2; k <= 12; ++k)
  {
    for (int choice = 0; choice < 4; ++choice)
    {
      const bool quads = choice & 1;
      const bool modified = choice & 2;
      SCOPED_TRACE(std::to_string(k) + (quads ? " quads" : " triangles") +
        (modified ? ", modified" : ", plain"));
      const double t = Pi / k;
      const double gamma = !modified ? 3. / 8.
        : quads                      ? 3. / 8. - std::cos(t) / 4.
                                     : 1. / 2. - std::cos(t) / 4.;
      const TransversalMask mask = GetTransversalMask(k, quads, modified);
      const Sums sums = ApplyStep(mask, k, quads, gamma);
      const double value = sums.Edges[0] / std::sin(t);
      const double bound = 1e-13;
      EXPECT_NEAR(sums.Own, value * mask.Own, bound * std::abs(mask.Own));
      EXPECT_NEAR(sums.End, value * mask.End, bound * std::abs(mask.Own));
      for (int j = 1; j < k; ++j)
      {
        EXPECT_NEAR(sums.Edges[j - 1], value * std::sin(j * t), bound);
      }
      for (int j = 0; j < k; ++j)
      {
        EXPECT_NEAR(
          sums.Faces[j], value * mask.Faces * (std::sin(j * t) + std::sin((j + 1) * t)), bound);
      }
    }
  }
}
