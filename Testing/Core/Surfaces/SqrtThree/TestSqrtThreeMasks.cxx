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
  for (int test = 2; test < 26; ++test)
  {
    const int k = test / 2;
    const double far = test % 2 == 0 ? 1. / 3. : GetSqrtThreeFarWeight(Pi / k);
    SCOPED_TRACE(test);
    const SqrtThreeTransversalMask even(k, far);
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
    EXPECT_NEAR(
      odd.Own, (19. * even.Own + 16. * 2. * even.End) / 27. + (1. - 2. * far) * sum, 1e-13 * k);
    EXPECT_NEAR(odd.End, (10. * even.End + even.End + 4. * even.Own) / 27., 1e-13 * k);
    // The first one makes the centres of the triangles.
    const double value = k == 1 ? 1. / 9.
      : test % 2 == 0           ? (2. + 2. * std::cos(Pi / k)) / 9.
                                : 1. / 3.; // by the modified rule as along the curve
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

/// Two steps in a sector of k triangles at a corner shrink the functions cos(j angle) and sin(j
/// angle) of its edges j to a third, and all others that are 0 on both curves by more than that,
/// after flatness at concave corners.
TEST(SqrtThreeMasks, SectorsOfCornersShrinkToAThird)
{
  for (const double alpha : { Pi / 8., Pi / 2., 7. / 8. * Pi, Pi, 9. / 8. * Pi, 1.5 * Pi })
  {
    for (int k = 2; k <= 12; ++k)
    {
      const double t = alpha / k;
      const double far = GetSqrtThreeFarWeight(t);
      SCOPED_TRACE(std::to_string(k) + " triangles, angle " + std::to_string(alpha));
      if (t > 2. / 3. * Pi)
      {
        EXPECT_EQ(far, 1.);
        EXPECT_TRUE(std::isinf(GetSqrtThreeThirdEigenvalue(k, alpha)));
        continue;
      }
      for (int j = 1; j < k; ++j)
      {
        const auto twice = [&](const auto& wave)
        { return far * (wave((j - 1) * t) + 2. * wave(j * t) + wave((j + 1) * t)) / 3.; };
        EXPECT_NEAR(twice([](double x) { return std::cos(x); }), std::cos(j * t) / 3., 1e-14);
        EXPECT_NEAR(twice([](double x) { return std::sin(x); }), std::sin(j * t) / 3., 1e-14);
      }
      const double third = GetSqrtThreeThirdEigenvalue(k, alpha) * 4. / 9.;
      EXPECT_NEAR(third, far / 3. * (2. + 2. * std::cos(Pi / k)), 1e-15);
      EXPECT_EQ(third < 1. / 3. - 1e-9, alpha < Pi - 1e-9);
      EXPECT_TRUE(alpha > Pi || (far > 0. && far <= 1. / 2.)); // no weight is negative
    }
  }
  EXPECT_NEAR(GetSqrtThreeFarWeight(Pi / 3.), 1. / 3., 1e-15); // the plain rule
  EXPECT_EQ(GetSqrtThreeFarWeight(0.), 1. / 3.);
}
