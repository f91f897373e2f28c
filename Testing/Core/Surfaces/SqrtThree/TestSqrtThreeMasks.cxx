// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 11: the weights of sqrt(3), against what they are made for.
#include "Core/Surfaces/SqrtThree/SqrtThreeMasks.h"

#include <gtest/gtest.h>

using namespace subdivision;

TEST(SqrtThreeMasks, WeightsOfRings)
{
  EXPECT_NEAR(ComputeSqrtThreeRingWeight(3), 5. / 9., 1e-15);
  EXPECT_NEAR(ComputeSqrtThreeRingWeight(4), 4. / 9., 1e-15);
  EXPECT_NEAR(ComputeSqrtThreeRingWeight(6), 1. / 3., 1e-15);
  for (int n = 1; n < 40; ++n)
  {
    EXPECT_EQ(GetSqrtThreeRingWeight(n), ComputeSqrtThreeRingWeight(n));
  }
  EXPECT_EQ(GetSqrtThreeRingWeight(0), 0.); // without neighbours
}

TEST(SqrtThreeMasks, TablesOfRegularVerticesAndCentres)
{
  ASSERT_EQ(SqrtThreeVertex.size(), 7u);
  ASSERT_EQ(SqrtThreeCentre.size(), 3u);
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_NEAR(SqrtThreeVertex[i], i == 0 ? 2. / 3. : 1. / 18., 1e-15) << i;
  }
  for (const double weight : SqrtThreeCentre)
  {
    EXPECT_EQ(weight, 1. / 3.);
  }
}

TEST(SqrtThreeMasks, AcrossACurveOneTriangleHasAMaskOfItsOwn)
{
  const SqrtThreeTransversalMask mask(1);
  EXPECT_EQ(mask.Own, -2.);
  EXPECT_EQ(mask.End, 1.);
  EXPECT_EQ(mask.Inside, (std::vector<double>{ 0., 0. }));
}

/// The sum of the points that two steps make, with the weights of a mask, is that of the points of
/// before, times the eigenvalue. The second of these steps cuts the curve into three.
TEST(SqrtThreeMasks, ATransversalMaskIsALeftEigenvectorOfTwoSteps)
{
  for (int k = 1; k <= 12; ++k)
  {
    SCOPED_TRACE(k);
    const SqrtThreeTransversalMask even(k);
    SqrtThreeTransversalMask odd = even;
    odd.MakeOdd();
    const auto size = static_cast<std::size_t>(k) + 1;
    ASSERT_EQ(even.Inside.size(), size);
    ASSERT_EQ(odd.Inside.size(), size + 1);
    EXPECT_EQ(even.Inside.front(), 0.);
    EXPECT_EQ(even.Inside.back(), 0.);
    EXPECT_EQ(odd.Inside.front(), 0.);
    EXPECT_EQ(odd.Inside.back(), 0.);
    // The second step.
    double sum = 0.;
    for (std::size_t j = 0; j < size; ++j)
    {
      sum += even.Inside[j];
      EXPECT_NEAR(even.Inside[j], std::sin(static_cast<double>(j) * Pi / k), 1e-15);
    }
    EXPECT_NEAR(odd.Own, (19. * even.Own + 16. * 2. * even.End) / 27. + sum / 3., 1e-13 * k);
    EXPECT_NEAR(odd.End, (10. * even.End + even.End + 4. * even.Own) / 27., 1e-13 * k);
    // The first one makes the centres of the triangles.
    const double value = k == 1 ? 1. / 9. : (2. + 2. * std::cos(Pi / k)) / 9.;
    double own = odd.Own;
    for (double centre : odd.Inside)
    {
      own += centre / 3.;
    }
    EXPECT_NEAR(own, value * even.Own, 1e-13 * k);
    EXPECT_NEAR(odd.End + odd.Inside[1] / 3., value * even.End, 1e-13 * k);
    for (std::size_t j = 1; j + 1 < size; ++j)
    {
      EXPECT_NEAR((odd.Inside[j] + odd.Inside[j + 1]) / 3., value * even.Inside[j], 1e-15);
    }
  }
}
