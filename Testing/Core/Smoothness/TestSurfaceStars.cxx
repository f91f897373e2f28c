// SPDX-License-Identifier: BSD-3-Clause
// Eigenvalues and characteristic maps of surface schemes: against closed forms, and against what
// the survey and Mathematics 9 to 12 say of valences at which conditions fail.
#include "Precompiled.h"

#include "Core/Smoothness/SurfaceStars.h"

#include "Core/Rules/Pi.h"

using namespace subdivision;

namespace
{

using Kind = SurfaceStar::Kind;
using Scheme = SurfaceSchemeKind;

SmoothnessFacts Examine(Scheme scheme, int faces, Kind kind = Kind::Closed, bool modified = true,
  double angle = 0., double flatness = 0.)
{
  SurfaceStar star;
  star.Scheme = scheme;
  star.Faces = faces;
  star.Where = kind;
  star.ModifiedBoundary = modified;
  star.Angle = angle;
  star.Flatness = flatness;
  return ExamineSurface(star, true);
}

void ExpectPair(const SmoothnessFacts& facts, double value)
{
  EXPECT_NEAR(facts.Eigenvalues[0], 1., 1e-10);
  EXPECT_NEAR(facts.Eigenvalues[1], value, 1e-8);
  EXPECT_NEAR(facts.Eigenvalues[2], value, 1e-8);
}

void ExpectSmooth(const SmoothnessFacts& facts)
{
  EXPECT_EQ(facts.Condition, Answer::Yes);
  EXPECT_EQ(facts.Regular, Answer::Yes);
  EXPECT_EQ(facts.Injective, Answer::Yes);
  EXPECT_FALSE(facts.Fails());
}

double Cosine(int times, int k)
{
  return std::cos(times * Pi / k);
}

}

TEST(SmoothnessOfSurfaces, LoopInside)
{
  for (int k = 3; k <= 20; ++k)
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts facts = Examine(Scheme::Loop, k);
    ExpectPair(facts, 3. / 8. + Cosine(2, k) / 4.);
    ExpectSmooth(facts);
    EXPECT_EQ(facts.Samples, 12 * k);
    if (k >= 7)
    {
      EXPECT_NEAR(facts.Eigenvalues[3], 3. / 8. + Cosine(4, k) / 4., 1e-8);
    }
  }
}

TEST(SmoothnessOfSurfaces, CatmullClarkInside)
{
  for (int k = 3; k <= 20; ++k)
  {
    SCOPED_TRACE(k);
    const double c = Cosine(2, k);
    const SmoothnessFacts facts = Examine(Scheme::CatmullClark, k);
    ExpectPair(facts, (5. + c + std::sqrt((9. + c) * (1. + c))) / 16.);
    ExpectSmooth(facts);
  }
}

TEST(SmoothnessOfSurfaces, ButterflyInside)
{
  for (int k = 3; k <= 12; ++k)
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts facts = Examine(Scheme::ModifiedButterfly, k);
    ExpectPair(facts, 1. / 2.);
    EXPECT_NEAR(facts.Eigenvalues[3], 1. / 4., 1e-4); // it lacks eigenvectors, and so is sensitive
    ExpectSmooth(facts);
  }
}

/// Kobbelt's equation (4), for two steps.
TEST(SmoothnessOfSurfaces, SqrtThreeInside)
{
  for (int k = 3; k <= 12; ++k)
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts facts = Examine(Scheme::SqrtThree, k);
    ExpectPair(facts, 4. / 9. * Cosine(1, k) * Cosine(1, k));
    ExpectSmooth(facts);
    if (k >= 6)
    {
      const double a = (4. - 2. * Cosine(2, k)) / 9.;
      const double third =
        std::max((2. / 3. - a) * (2. / 3. - a), 4. / 9. * Cosine(2, k) * Cosine(2, k));
      EXPECT_NEAR(facts.Eigenvalues[3], std::max(third, 1. / 9.), 1e-6);
    }
  }
}

TEST(SmoothnessOfSurfaces, FourEightInside)
{
  const double expected[] = { 0.4083, 0.5, 0.5513, 0.5819, 0.6013, 0.6142, 0.6233 };
  for (int k = 3; k <= 9; ++k)
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts facts = Examine(Scheme::FourEight, k);
    EXPECT_NEAR(facts.Eigenvalues[1], expected[k - 3], 5e-5);
    EXPECT_NEAR(facts.Eigenvalues[2], expected[k - 3], 5e-5);
    ExpectSmooth(facts);
  }
}

TEST(SmoothnessOfSurfaces, DualSchemes)
{
  for (const int k : { 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 20, 50 })
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts doo = Examine(Scheme::DooSabin, k);
    ExpectPair(doo, 1. / 2.);
    EXPECT_NEAR(doo.Eigenvalues[3], k == 3 ? 0. : 1. / 4., 1e-8);
    ExpectSmooth(doo);
    const SmoothnessFacts midedge = Examine(Scheme::Midedge, k);
    ExpectPair(midedge, Cosine(1, k) * Cosine(1, k));
    if (k == 3)
    {
      EXPECT_EQ(midedge.Condition, Answer::No);
      EXPECT_EQ(midedge.Regular, Answer::None);
      continue;
    }
    ExpectSmooth(midedge);
    EXPECT_EQ(doo.Samples, 164 * k);
    EXPECT_EQ(midedge.Samples, 164 * k);
  }
}

/// The plain rule is C^1 for up to five triangles, the survey's for all.
TEST(SmoothnessOfSurfaces, LoopAtBoundaries)
{
  for (int k = 1; k <= 12; ++k)
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts plain = Examine(Scheme::Loop, k, Kind::Curve, false);
    EXPECT_EQ(plain.Condition, k <= 5 ? Answer::Yes : Answer::No);
    EXPECT_EQ(plain.Regular, k <= 5 ? Answer::Yes : Answer::None);
    EXPECT_EQ(plain.Fails(), k > 5);
    const SmoothnessFacts modified = Examine(Scheme::Loop, k, Kind::Curve);
    ExpectSmooth(modified);
    if (k > 1)
    {
      ExpectPair(modified, 1. / 2.);
    }
  }
}

TEST(SmoothnessOfSurfaces, OthersAtBoundaries)
{
  for (int k = 2; k <= 9; ++k)
  {
    SCOPED_TRACE(k);
    ExpectSmooth(Examine(Scheme::CatmullClark, k, Kind::Curve));
    ExpectSmooth(Examine(Scheme::ModifiedButterfly, k, Kind::Curve));
    EXPECT_EQ(Examine(Scheme::CatmullClark, k, Kind::Curve, false).Condition,
      k <= 3 ? Answer::Yes : Answer::No);
    EXPECT_EQ(Examine(Scheme::FourEight, k, Kind::Curve, false).Condition,
      k <= 3 ? Answer::Yes : Answer::No);
    const SmoothnessFacts fourEight = Examine(Scheme::FourEight, k, Kind::Curve);
    ExpectPair(fourEight, 1. / 2.);
    ExpectSmooth(fourEight);
    const SmoothnessFacts plain = Examine(Scheme::SqrtThree, k, Kind::Curve, false);
    EXPECT_EQ(plain.Condition, k <= 5 ? Answer::Yes : Answer::No);
    EXPECT_NEAR(plain.Eigenvalues[k == 2 ? 2 : 1], (2. + 2. * Cosine(1, k)) / 9., 1e-8);
    const SmoothnessFacts three = Examine(Scheme::SqrtThree, k, Kind::Curve);
    ExpectPair(three, 1. / 3.);
    EXPECT_NEAR(three.Eigenvalues[3],
      std::max(1. / 9., (1. + Cosine(2, k)) / (3. + 3. * Cosine(1, k))), 1e-8);
    ExpectSmooth(three);
    EXPECT_EQ(Examine(Scheme::DooSabin, k, Kind::Curve).Condition, Answer::None);
  }
}

TEST(SmoothnessOfSurfaces, Corners)
{
  for (int k = 1; k <= 9; ++k)
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts loop = Examine(Scheme::Loop, k, Kind::Corner, true, Pi / 2.);
    ExpectPair(loop, 1. / 2.);
    ExpectSmooth(loop);
    EXPECT_EQ(Examine(Scheme::Loop, k, Kind::Corner, false, Pi / 2.).Condition,
      k <= 2 ? Answer::Yes : Answer::No);
    ExpectSmooth(Examine(Scheme::CatmullClark, k, Kind::Corner, true, Pi / 2.));
    if (k > 1)
    {
      // Flatness makes a concave corner as smooth as a convex one.
      const double l3 = 1. / 2. + (Cosine(1, k) - std::cos(1.5 * Pi / k)) / 4.;
      const double s = std::max(0., 1. - 1. / 4. / l3);
      const SmoothnessFacts concave = Examine(Scheme::Loop, k, Kind::Corner, true, 1.5 * Pi, s);
      EXPECT_NEAR(concave.Eigenvalues[3], 1. / 4., 1e-6);
      ExpectSmooth(concave);
      EXPECT_EQ(Examine(Scheme::Loop, k, Kind::Corner, true, 1.5 * Pi, 0.).Condition, Answer::No);
    }
  }
}

TEST(SmoothnessOfSurfaces, EndsOfCreases)
{
  SurfaceStar star;
  star.EndsCrease = true;
  const SmoothnessFacts facts = ExamineSurface(star, true);
  ExpectPair(facts, 1. / 2.);
  EXPECT_NEAR(facts.Eigenvalues[3], 0.3384, 5e-5); // Mathematics 9
  ExpectSmooth(facts);
}

TEST(SmoothnessOfSurfaces, StarsThatDoNotExist)
{
  for (const Scheme scheme : { Scheme::Loop, Scheme::CatmullClark, Scheme::DooSabin })
  {
    const SmoothnessFacts facts = Examine(scheme, 2);
    EXPECT_EQ(facts.Condition, Answer::None);
    EXPECT_FALSE(facts.Fails());
    EXPECT_EQ(facts.Valence, 2);
  }
  EXPECT_EQ(Examine(Scheme::DooSabin, 60).Eigenvalues[0], 0.);
  for (const int faces : { 2, 40, 100, 1000000 }) // too few, or too many for the algebra
  {
    const SmoothnessFacts facts = Examine(Scheme::CatmullClark, faces);
    EXPECT_EQ(facts.Eigenvalues[0], 0.);
    EXPECT_EQ(facts.Condition, Answer::None);
  }
}

TEST(SmoothnessOfSurfaces, WithoutSamplesThereIsNoMap)
{
  const SmoothnessFacts facts = ExamineSurface(SurfaceStar(), false);
  EXPECT_EQ(facts.Condition, Answer::Yes);
  EXPECT_EQ(facts.Regular, Answer::None);
  EXPECT_EQ(facts.Injective, Answer::None);
  EXPECT_EQ(facts.Samples, 0);
}
