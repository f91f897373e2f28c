// SPDX-License-Identifier: BSD-3-Clause
// The masks of the modified Butterfly scheme: what they do to waves around a vertex. The operator
// itself is tested in Python (test_butterfly.py), the filter in TestSurfaceSubdivision.cxx.
#include "Precompiled.h"

#include "Core/Surfaces/Butterfly/ButterflyMasks.h"

namespace
{

using namespace subdivision::butterfly;

TEST(SurfaceButterfly, WavesAroundAVertex)
{
  for (int k = 3; k <= 40; ++k)
  {
    double sum = 0.;
    for (int j = 0; j < k; ++j)
    {
      sum += Ring(k, j);
    }
    EXPECT_NEAR(sum, 1. - Centre, 1e-14) << k;
    // Linear functions are halved, the next waves quartered, the others vanish.
    for (int m = 1; m <= k / 2; ++m)
    {
      double factor = 0.;
      for (int j = 0; j < k; ++j)
      {
        factor += Ring(k, j) * std::cos(2. * subdivision::Pi * m * j / k);
      }
      EXPECT_NEAR(factor, m == 1 ? 0.5 : m == 2 ? 0.25 : 0., 1e-14) << k << " " << m;
    }
  }
}

TEST(SurfaceButterfly, WeightsOfTwoToFourNeighbours)
{
  const std::vector<std::vector<double>> expected{ { 3. / 8., -1. / 8. },
    { 5. / 12., -1. / 12., -1. / 12. }, { 3. / 8., 0., -1. / 8., 0. } };
  for (const std::vector<double>& ring : expected)
  {
    const int k = static_cast<int>(ring.size());
    for (int j = 0; j < k; ++j)
    {
      EXPECT_NEAR(Ring(k, j), ring[static_cast<std::size_t>(j)], 1e-15) << k << " " << j;
    }
  }
  EXPECT_EQ(Centre, 0.75);
}

TEST(SurfaceButterfly, WavesInASectorOfACurve)
{
  for (int k = 2; k <= 40; ++k)
  {
    const double t = subdivision::Pi / k;
    for (int i = 1; i < k; ++i)
    {
      double ones = CurveCentre(k, i);
      double across = 0.;
      double along = 0.;
      double second = 0.;
      for (int j = 0; j <= k; ++j)
      {
        ones += CurveRing(k, i, j);
        across += CurveRing(k, i, j) * std::sin(j * t);
        along += CurveRing(k, i, j) * std::cos(j * t);
        second += CurveRing(k, i, j) * std::sin(2 * j * t);
      }
      EXPECT_NEAR(ones, 1., 1e-13) << k;
      EXPECT_NEAR(across, std::sin(i * t) / 2., 1e-13) << k;
      EXPECT_NEAR(along, std::cos(i * t) / 2., 1e-13) << k;
      EXPECT_NEAR(second, std::sin(2 * i * t) / 4., 1e-13) << k;
    }
  }
}

TEST(SurfaceButterfly, WavesInASectorOfACorner)
{
  for (int k = 2; k <= 12; ++k)
  {
    for (const double angle : { subdivision::Pi / 8., subdivision::Pi / 2.,
           7. * subdivision::Pi / 8., 9. * subdivision::Pi / 8., 15. * subdivision::Pi / 8. })
    {
      for (int i = 1; i < k; ++i)
      {
        double sine = 0.;
        double cosine = 0.;
        double wave = 0.;
        double rest = 0.;
        for (int j = 0; j <= k; ++j)
        {
          const double weight = CornerRing(k, angle, i, j);
          sine += weight * std::sin(j * angle / k);
          cosine += weight * std::cos(j * angle / k);
          wave += weight * std::sin(j * subdivision::Pi / k);
          rest += weight * std::sin(2. * j * subdivision::Pi / k);
        }
        EXPECT_NEAR(sine, std::sin(i * angle / k) / 2., 1e-12);
        EXPECT_NEAR(cosine, std::cos(i * angle / k) / 2., 1e-12);
        EXPECT_NEAR(wave, std::sin(i * subdivision::Pi / k) / 4., 1e-12);
        EXPECT_NEAR(rest, 0., 1e-12);
      }
    }
  }
}

}
