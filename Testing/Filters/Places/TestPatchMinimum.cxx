// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPatchMinimum.cxx
 * The least value of polynomials over lines, triangles and quads, against many places.
 */
#include "Precompiled.h"

#include "Private/Places/PatchMinimum.h"

using namespace subdivision;

namespace
{

double Choose(int n, int k)
{
  return std::round(std::exp(std::lgamma(n + 1.) - std::lgamma(k + 1.) - std::lgamma(n - k + 1.)));
}

/// Sums Bernstein polynomials at a place.
double Evaluate(PatchKind kind, int degree, const PatchFactors& factors, double u, double v)
{
  double sum = 0.;
  const auto power = [](double x, int n) { return n == 0 ? 1. : std::pow(x, n); };
  for (int j = 0; j <= (kind == PatchKind::Line ? 0 : degree); ++j)
  {
    for (int i = 0; i <= (kind == PatchKind::Triangle ? degree - j : degree); ++i)
    {
      const double factor = factors[PatchSide * j + i];
      sum += factor *
        (kind == PatchKind::Triangle ? Choose(degree, i) * Choose(degree - i, j) * power(u, i) *
              power(v, j) * power(std::max(0., 1. - u - v), degree - i - j)
                                     : Choose(degree, i) * power(u, i) * power(1. - u, degree - i) *
              (kind == PatchKind::Line
                  ? 1.
                  : Choose(degree, j) * power(v, j) * power(1. - v, degree - j)));
    }
  }
  return sum;
}

}

TEST(PatchMinimum, NoPlaceHasLess)
{
  std::mt19937 random(1);
  const auto draw = [&random] { return random() / 2147483648. - 1.; };
  for (const PatchKind kind : { PatchKind::Line, PatchKind::Triangle, PatchKind::Quad })
  {
    const int degree = kind == PatchKind::Triangle ? 8 : 6;
    for (int test = 0; test < 20; ++test)
    {
      PatchFactors factors{};
      std::generate(factors.begin(), factors.end(), draw);
      PatchMinimum least{ 10., {} };
      ASSERT_TRUE(LowerToPatch(kind, degree, factors, WholePatch, 1e-13, least));
      EXPECT_NEAR(Evaluate(kind, degree, factors, least.At[0], least.At[1]), least.Value, 1e-12);
      double sampled = 10.;
      constexpr int size = 100;
      for (int i = 0; i <= size; ++i)
      {
        for (int j = 0; j <= (kind == PatchKind::Triangle ? size - i : size); ++j)
        {
          sampled = std::min(sampled,
            Evaluate(
              kind, degree, factors, static_cast<double>(i) / size, static_cast<double>(j) / size));
        }
      }
      EXPECT_LE(least.Value, sampled + 1e-12);
      EXPECT_GE(least.Value, sampled - 0.02);
      PatchMinimum less{ least.Value - 1e-6, {} };
      EXPECT_FALSE(LowerToPatch(kind, degree, factors, WholePatch, 1e-13, less));
    }
  }
}
