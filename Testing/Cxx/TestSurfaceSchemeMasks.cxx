// SPDX-License-Identifier: BSD-3-Clause
// SPEC 11 and 12: the masks of the schemes, by what they have to reproduce.
#include "Core/SchemeMasks.h"

#include <gtest/gtest.h>

#include <vector>

using namespace subdivision;

namespace
{

constexpr double Tight = 1e-13;

}

TEST(SchemeMasks, SqrtThreeHasThePapersSpectrum)
{
  for (int n = 3; n <= 12; ++n)
  {
    const double a = SqrtThreeRing(n);
    // Eq. 4: the eigenvalue of the centre against its ring is that of two thirds, squared.
    const double inner = 2. / 3. - a;
    const double outer = (2. + 2. * std::cos(2. * Pi / n)) / 9.;
    EXPECT_NEAR(inner, outer, Tight) << n; // eq. 5: (2/3 - a)^2 = ((2 + 2 cos)/9)^2
    // The limit row is a left eigenvector: w A = w with A of one step on (centre, mean of the
    // ring).
    const double b = SqrtThreeLimitRing(n);
    EXPECT_NEAR((1. - b) * (1. - a) + b / 3., 1. - b, Tight);
    EXPECT_NEAR((1. - b) * a + b * 2. / 3., b, Tight);
    EXPECT_NEAR(SqrtThreeDecay(n, 3), inner * inner * inner, Tight);
  }
  EXPECT_NEAR(SqrtThreeRing(6), 1. / 3., Tight);
}

TEST(SchemeMasks, ThirdsAreTheCubicSpline)
{
  // (1 + z + z^2)^4 / 27
  std::vector<double> mask{ 1. / 27. };
  for (int factor = 0; factor < 4; ++factor)
  {
    std::vector<double> product(mask.size() + 2, 0.);
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        product[i + k] += mask[i];
      }
    }
    mask = product;
  }
  EXPECT_NEAR(mask[1], CurveThirdVertex[0], Tight);
  EXPECT_NEAR(mask[4], CurveThirdVertex[1], Tight);
  EXPECT_NEAR(mask[7], CurveThirdVertex[2], Tight);
  EXPECT_NEAR(mask[8], CurveThirdEdge[0], Tight);
  EXPECT_NEAR(mask[5], CurveThirdEdge[1], Tight);
  EXPECT_NEAR(mask[2], CurveThirdEdge[2], Tight);
}

TEST(SchemeMasks, ButterflyAroundAVertexHalvesAndQuarters)
{
  for (int k = 3; k <= 12; ++k)
  {
    for (int frequency = 0; frequency < k; ++frequency)
    {
      double sum = 0.;
      for (int j = 0; j < k; ++j)
      {
        sum += ButterflyRing(k, j) * std::cos(2. * Pi * frequency * j / k);
      }
      const int f = std::min(frequency, k - frequency);
      // The modes of linear and quadratic functions; k = 4 has both quadratic ones in one.
      const double expected = f <= 0 ? 1. / 4. : f == 1 ? 1. / 2. : f == 2 ? 1. / 4. : 0.;
      EXPECT_NEAR(sum, expected, Tight) << k << " " << frequency;
    }
  }
  EXPECT_NEAR(ButterflyRing(2, 0) + ButterflyRing(2, 1) + ButterflyCentre, 1., Tight);
}

TEST(SchemeMasks, RegularButterflyReproducesCubics)
{
  // Ends (0,0), (1,0); opposite (0,1) and (1,-1); wings in the lattice of both.
  const double points[8][3] = { { 0, 0, ButterflyEnd }, { 1, 0, ButterflyEnd },
    { 0, 1, ButterflyOpposite }, { 1, -1, ButterflyOpposite }, { 1, 1, ButterflyWing },
    { -1, 1, ButterflyWing }, { 0, -1, ButterflyWing }, { 2, -1, ButterflyWing } };
  for (int i = 0; i <= 3; ++i)
  {
    for (int j = 0; i + j <= 3; ++j)
    {
      double sum = 0.;
      for (const auto& p : points)
      {
        sum += p[2] * std::pow(p[0], i) * std::pow(p[1], j);
      }
      EXPECT_NEAR(sum, std::pow(0.5, i) * (j == 0 ? 1. : 0.), Tight) << i << " " << j;
    }
  }
  for (int i = 0; i <= 3; ++i)
  {
    const double sum = FourPointEnd * (std::pow(0., i) + 1.) +
      FourPointBeyond * (std::pow(-1., i) + std::pow(2., i));
    EXPECT_NEAR(sum, std::pow(0.5, i), Tight) << i;
  }
}

TEST(SchemeMasks, ButterflySectorsReproduceTheHalfDisk)
{
  for (int k = 2; k <= 8; ++k)
  {
    const double t = Pi / k;
    for (int i = 1; i < k; ++i)
    {
      double one = ButterflySectorCentre(k, i);
      double x = 0.;
      double y = 0.;
      double xy = 0.;
      for (int j = 0; j <= k; ++j)
      {
        const double weight = ButterflySectorRing(k, i, j);
        one += weight;
        x += weight * std::cos(j * t);
        y += weight * std::sin(j * t);
        xy += weight * std::sin(2 * j * t);
      }
      EXPECT_NEAR(one, 1., Tight) << k << " " << i;
      EXPECT_NEAR(x, std::cos(i * t) / 2., Tight) << k << " " << i;
      EXPECT_NEAR(y, std::sin(i * t) / 2., Tight) << k << " " << i;
      EXPECT_NEAR(xy, std::sin(2 * i * t) / 4., Tight) << k << " " << i;
    }
  }
}

TEST(SchemeMasks, ButterflyCornersReproduceTheirSector)
{
  for (double alpha : { Pi / 8., Pi / 2., 7. * Pi / 8., 9. * Pi / 8., 15. * Pi / 8. })
  {
    for (int k = 2; k <= 8; ++k)
    {
      const double t = alpha / k;
      for (int i = 1; i < k; ++i)
      {
        double x = 0.;
        double y = 0.;
        double mode = 0.;
        double other = 0.;
        for (int j = 0; j <= k; ++j)
        {
          const double weight = ButterflyCornerRing(k, alpha, i, j);
          x += weight * std::cos(j * t);
          y += weight * std::sin(j * t);
          mode += weight * std::sin(j * Pi / k);
          other += weight * std::sin(2 * j * Pi / k);
        }
        EXPECT_NEAR(x, std::cos(i * t) / 2., 1e-12) << alpha << " " << k << " " << i;
        EXPECT_NEAR(y, std::sin(i * t) / 2., 1e-12) << alpha << " " << k << " " << i;
        EXPECT_NEAR(mode, std::sin(i * Pi / k) / 4., 1e-12) << alpha << " " << k << " " << i;
        EXPECT_NEAR(other, 0., 1e-12) << alpha << " " << k << " " << i;
      }
    }
  }
}

TEST(SchemeMasks, ButterflyNearCreasesReproducesQuadratics)
{
  // v = (0,1), w = (0,0) on the crease y = 0; neighbours of w: (1,0), (0,1), (-1,1), (-1,0).
  const double near[7][3] = { { 0, 1, interiorcrease::Interior }, { 0, 0, interiorcrease::Crease },
    { -1, 1, interiorcrease::OppositeInside }, { 1, 0, interiorcrease::OppositeOnCrease },
    { -1, 2, interiorcrease::WingInteriorInside }, { 1, 1, interiorcrease::OtherWing },
    { -1, 0, interiorcrease::OtherWing } };
  // v = (0,0), w = (1,0), the missing wings are those of (0,1).
  const double between[5][3] = { { 0, 0, creasecrease::End }, { 1, 0, creasecrease::End },
    { 1, -1, creasecrease::Opposite }, { 0, -1, creasecrease::Wing },
    { 2, -1, creasecrease::Wing } };
  auto reproduces = [](const auto& points, double x, double y, int degree)
  {
    for (int i = 0; i <= degree; ++i)
    {
      for (int j = 0; i + j <= degree; ++j)
      {
        double sum = 0.;
        for (const auto& p : points)
        {
          sum += p[2] * std::pow(p[0], i) * std::pow(p[1], j);
        }
        EXPECT_NEAR(sum, std::pow(x, i) * std::pow(y, j), Tight) << i << " " << j;
      }
    }
  };
  reproduces(near, 0., 0.5, 2);
  reproduces(between, 0.5, 0., 1);
}

TEST(SchemeMasks, DooSabinOnQuadsIsTheBiquadraticSpline)
{
  const double quad[4] = { 9. / 16., 3. / 16., 1. / 16., 3. / 16. };
  for (int j = 0; j < 4; ++j)
  {
    EXPECT_NEAR(DooSabinCorner(4, j), quad[j], Tight);
  }
  for (int k = 3; k <= 12; ++k)
  {
    // Spectrum 1, 1/2, 1/2, 1/4, ...
    for (int frequency = 0; frequency <= k / 2; ++frequency)
    {
      double sum = 0.;
      for (int j = 0; j < k; ++j)
      {
        sum += DooSabinCorner(k, j) * std::cos(2. * Pi * frequency * j / k);
      }
      EXPECT_NEAR(sum, frequency == 0 ? 1. : frequency == 1 ? 0.5 : 0.25, Tight) << k;
    }
  }
}

TEST(SchemeMasks, FourEightIsItsGeneratingFunction)
{
  // (1 + z1)^2 (1 + z2)^2 / 8: vertices of the next level at even i + j in the old lattice.
  const double line[3] = { 1., 2., 1. };
  EXPECT_NEAR(line[1] * line[1] / 8., FourEightVertex, Tight);
  EXPECT_NEAR(line[0] * line[0] / 8., FourEightRing / 4., Tight); // the four neighbours
  EXPECT_NEAR(line[0] * line[1] / 8., 1. / 4., Tight);            // the mean of a quad
}
