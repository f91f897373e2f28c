// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: the weights of the limits of 4-8, against a step written down from its rules.
#include "Precompiled.h"

#include "Core/Surfaces/FourEight/FourEightMasks.h"

#include "Core/Rules/Pi.h"

using namespace subdivision;

namespace
{

/// Values around a vertex with k regular quads: at the vertex, at its neighbours j, at the opposite
/// corner of face j, straight ahead of neighbour j, and at both knight's moves beyond face j: [0]
/// beyond the edge of neighbour j, [1] beyond that of neighbour j + 1.
struct Star
{
  explicit Star(int k)
    : Edges(k)
    , Faces(k)
    , Ahead(k)
    , Knights{ std::vector<double>(k), std::vector<double>(k) }
  {
  }
  int GetSize() const { return static_cast<int>(this->Edges.size()); }

  double Own = 0.;
  std::vector<double> Edges;
  std::vector<double> Faces;
  std::vector<double> Ahead;
  std::vector<double> Knights[2];
};

Star DrawStar(int k)
{
  std::mt19937 random(k);
  std::uniform_real_distribution<double> value(-1., 1.);
  Star star(k);
  star.Own = value(random);
  for (std::vector<double>* values :
    { &star.Edges, &star.Faces, &star.Ahead, &star.Knights[0], &star.Knights[1] })
  {
    for (double& one : *values)
    {
      one = value(random);
    }
  }
  return star;
}

/// The star after a step: its neighbours are the points of the faces, its opposite corners the old
/// neighbours. Neighbour j of the new star lies in the old face j, its face j at the old edge j
/// + 1.
Star Step(const Star& old)
{
  const int k = old.GetSize();
  Star made(k);
  double sum = 0.;
  for (int j = 0; j < k; ++j)
  {
    const int next = (j + 1) % k;
    sum += old.Edges[j];
    made.Edges[j] = (old.Own + old.Edges[j] + old.Edges[next] + old.Faces[j]) / 4.;
    made.Faces[j] =
      old.Edges[next] / 2. + (old.Own + old.Faces[j] + old.Faces[next] + old.Ahead[next]) / 8.;
    made.Ahead[j] = old.Faces[j] / 2. +
      (old.Edges[j] + old.Edges[next] + old.Knights[0][j] + old.Knights[1][j]) / 8.;
    // Points of the faces beyond the two sides at the old neighbour j + 1.
    made.Knights[0][j] =
      (old.Edges[next] + old.Faces[j] + old.Ahead[next] + old.Knights[1][j]) / 4.;
    made.Knights[1][j] =
      (old.Edges[next] + old.Faces[next] + old.Ahead[next] + old.Knights[0][next]) / 4.;
  }
  made.Own = old.Own / 2. + sum / (2. * k);
  return made;
}

double SumUp(const Star& star)
{
  using Totals = FourEightTotals;
  double sum = Totals::Own * star.Own;
  const double k = star.GetSize();
  for (int j = 0; j < star.GetSize(); ++j)
  {
    sum += (Totals::Edges * star.Edges[j] + Totals::Faces * star.Faces[j] +
             Totals::Ahead * star.Ahead[j]) /
      k;
    sum += Totals::Knights * (star.Knights[0][j] + star.Knights[1][j]) / (2. * k);
  }
  return sum;
}

/// The tangent in a direction; edge 0 is at the angle `first`.
double SumUp(const FourEightWave& wave, const Star& star, double first, double direction)
{
  const int k = star.GetSize();
  double sum = 0.;
  for (int j = 0; j < k; ++j)
  {
    const auto get = [&](double edge) { return std::cos(first + 2. * Pi * edge / k - direction); };
    sum += wave.Edge * get(j) * star.Edges[j] + wave.Face * get(j + 0.5) * star.Faces[j] +
      wave.Ahead * get(j) * star.Ahead[j];
    for (int side = 0; side < 2; ++side)
    {
      sum += (wave.KnightOfEdge * get(j + side) + wave.KnightOfFace * get(j + 0.5)) *
        star.Knights[side][j];
    }
  }
  return sum;
}

/// The star of a sector after two steps, the first of which leaves the curve alone. Neighbours 0
/// and k are on the curve, with the next points of it ahead.
Star StepTwiceBesideCurve(const Star& old, double far)
{
  const int k = old.GetSize() - 1; // faces; the last one of the star is not used
  const Star odd = Step(old);      // points of faces, corners, and knights that are inside
  const std::vector<double>& centres = odd.Edges;
  std::vector<double> ends(old.Edges); // the old neighbours after one step
  std::vector<double> beyond[2] = { old.Ahead, old.Ahead };
  for (int j = 0; j < k; ++j)
  {
    if (j > 0)
    {
      ends[j] = odd.Faces[j - 1];
    }
    beyond[0][j] = (old.Edges[j] + old.Faces[j] + old.Ahead[j] + old.Knights[0][j]) / 4.;
    beyond[1][j] = (old.Edges[j + 1] + old.Faces[j] + old.Ahead[j + 1] + old.Knights[1][j]) / 4.;
  }
  Star made(k + 1);
  made.Own = 3. / 4. * old.Own + (old.Edges[0] + old.Edges[k]) / 8.;
  for (const int end : { 0, k })
  {
    made.Edges[end] = (old.Own + old.Edges[end]) / 2.;
    made.Ahead[end] = 3. / 4. * old.Edges[end] + (old.Own + old.Ahead[end]) / 8.;
  }
  for (int j = 0; j < k; ++j)
  {
    if (j > 0)
    {
      made.Edges[j] = (1. - 3. * far) * old.Own + far * (centres[j - 1] + centres[j] + ends[j]);
      made.Ahead[j] =
        ends[j] / 2. + (centres[j - 1] + centres[j] + beyond[1][j - 1] + beyond[0][j]) / 8.;
    }
    made.Faces[j] = centres[j] / 2. + (old.Own + ends[j] + ends[j + 1] + odd.Ahead[j]) / 8.;
    for (int side = 0; side < 2; ++side)
    {
      made.Knights[side][j] = (centres[j] + ends[j + side] + beyond[side][j] + odd.Ahead[j]) / 4.;
    }
  }
  return made;
}

/// The tangent across the curve.
double SumUp(const FourEightCurveMask& mask, const Star& star)
{
  const int k = star.GetSize() - 1;
  const FourEightWave& wave = mask.Inside;
  const auto get = [k](double edge) { return std::sin(edge * Pi / k); };
  double sum = mask.Own * star.Own;
  for (const int end : { 0, k })
  {
    sum += mask.End * star.Edges[end] + mask.Beyond * star.Ahead[end];
  }
  for (int j = 0; j < k; ++j)
  {
    sum += j > 0 ? get(j) * (wave.Edge * star.Edges[j] + wave.Ahead * star.Ahead[j]) : 0.;
    sum += get(j + 0.5) * wave.Face * star.Faces[j];
    for (int side = 0; side < 2; ++side)
    {
      sum += (wave.KnightOfEdge * get(j + side) + wave.KnightOfFace * get(j + 0.5)) *
        star.Knights[side][j];
    }
  }
  return sum;
}

}

TEST(FourEightMasks, OfRegularVerticesAndQuads)
{
  ASSERT_EQ(FourEightVertex.size(), 5u);
  ASSERT_EQ(FourEightCentre.size(), 4u);
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(FourEightVertex[i], i == 0 ? 1. / 2. : 1. / 8.) << i;
  }
  for (const double weight : FourEightCentre)
  {
    EXPECT_EQ(weight, 1. / 4.);
  }
}

TEST(FourEightMasks, AStepMovesNoLimit)
{
  for (int k = 2; k <= 12; ++k)
  {
    const Star star = DrawStar(k);
    EXPECT_NEAR(SumUp(Step(star)), SumUp(star), 1e-15 * 8.) << k;
  }
  EXPECT_NEAR(FourEightTotals::Own + FourEightTotals::Edges + FourEightTotals::Faces +
      FourEightTotals::Ahead + FourEightTotals::Knights,
    1., 1e-15);
}

TEST(FourEightMasks, AStepMultipliesTangentsByTheEigenvalue)
{
  for (int k = 3; k <= 24; ++k)
  {
    SCOPED_TRACE(k);
    const FourEightWave wave(2. * Pi / k);
    EXPECT_EQ(wave.Edge, 1.);
    for (const double weight : { wave.Face, wave.Ahead, wave.KnightOfEdge, wave.KnightOfFace })
    {
      EXPECT_GT(weight, 0.);
    }
    EXPECT_GT(wave.Value, 0.5);
    EXPECT_LT(wave.Value, 1.);
    const Star star = DrawStar(k);
    for (const double direction : { 0., 1., 2. })
    {
      const double before = SumUp(wave, star, 0., direction);
      EXPECT_NEAR(SumUp(wave, Step(star), Pi / k, direction), wave.Value * before, 4e-14);
    }
  }
  EXPECT_NEAR(FourEightWave(Pi / 2.).Value, std::sqrt(0.5), 1e-15);
}

TEST(FourEightMasks, TwoStepsMultiplyTheTangentAcrossACurve)
{
  for (int test = 4; test < 26; ++test)
  {
    const int k = test / 2;
    const bool modified = test % 2 == 1;
    SCOPED_TRACE(test);
    const FourEightCurveMask mask(k, modified);
    EXPECT_NEAR(mask.Inside.Value, modified ? std::sqrt(0.5) : FourEightWave(Pi / k).Value, 1e-14);
    const double far = modified ? GetFourEightFarWeight(Pi / k) : 1. / 4.;
    const Star star = DrawStar(k + 1);
    const double value = mask.Inside.Value * mask.Inside.Value;
    EXPECT_NEAR(SumUp(mask, StepTwiceBesideCurve(star, far)), value * SumUp(mask, star), 1e-13 * k);
    Star constant(k + 1);
    constant.Own = 1.;
    for (std::vector<double>* values : { &constant.Edges, &constant.Faces, &constant.Ahead,
           &constant.Knights[0], &constant.Knights[1] })
    {
      std::fill(values->begin(), values->end(), 1.);
    }
    EXPECT_NEAR(SumUp(mask, constant), 0., 1e-13 * k);
  }
}

/// The weight beside curves is made for the eigenvalue 1/2 of two steps. At convex corners waves of
/// the sector then shrink faster, at concave ones they need flatness.
TEST(FourEightMasks, SectorsOfCorners)
{
  EXPECT_NEAR(GetFourEightFarWeight(Pi / 2.), 1. / 4., 1e-15); // the plain rule
  for (const double alpha : { Pi / 8., Pi / 2., 7. / 8. * Pi, Pi, 9. / 8. * Pi, 15. / 8. * Pi })
  {
    for (int k = 2; k <= 12; ++k)
    {
      SCOPED_TRACE(std::to_string(k) + " faces, angle " + std::to_string(alpha));
      const double far = GetFourEightFarWeight(alpha / k);
      const double own = FourEightWave(alpha / k, far).Value;
      EXPECT_NEAR(own * own, 0.5, 1e-13);
      const double third = GetFourEightThirdEigenvalue(k, alpha);
      EXPECT_EQ(third < 0.5 - 1e-9, alpha < Pi - 1e-9);
      EXPECT_TRUE(alpha > Pi || (far > 0. && far < 1. / 3.)); // no weight is negative
    }
  }
}
