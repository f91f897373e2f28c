// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBoxSpline.cxx
 * Weights of control points beside polynomials that are multiplied out: of the box spline (its
 * weights in Mathematics 8) and of products of B-splines; and what is exact at corners.
 */
#include "Precompiled.h"

#include "Core/Operators/BoxSpline.h"

using namespace subdivision;

namespace
{

constexpr PatchDirections Directions{ { { { 2., -1. } }, { { 0.5, 3. } } } };

/// A term of a polynomial in the weights of three corners.
struct Monomial
{
  double Factor;
  std::array<int, 3> Powers;
};

/// Of the control point at a corner; beyond the edge from there to the next; next to that, at the
/// corner. Times 12.
const std::vector<Monomial> Quartics[3] = {
  { { 6., { { 4, 0, 0 } } }, { 24., { { 3, 1, 0 } } }, { 24., { { 3, 0, 1 } } },
    { 24., { { 2, 2, 0 } } }, { 60., { { 2, 1, 1 } } }, { 24., { { 2, 0, 2 } } },
    { 8., { { 1, 3, 0 } } }, { 36., { { 1, 2, 1 } } }, { 36., { { 1, 1, 2 } } },
    { 8., { { 1, 0, 3 } } }, { 1., { { 0, 4, 0 } } }, { 6., { { 0, 3, 1 } } },
    { 12., { { 0, 2, 2 } } }, { 6., { { 0, 1, 3 } } }, { 1., { { 0, 0, 4 } } } },
  { { 1., { { 4, 0, 0 } } }, { 6., { { 3, 1, 0 } } }, { 2., { { 3, 0, 1 } } },
    { 12., { { 2, 2, 0 } } }, { 6., { { 2, 1, 1 } } }, { 6., { { 1, 3, 0 } } },
    { 6., { { 1, 2, 1 } } }, { 1., { { 0, 4, 0 } } }, { 2., { { 0, 3, 1 } } } },
  { { 1., { { 4, 0, 0 } } }, { 2., { { 3, 1, 0 } } } },
};

PatchPolynomial Expand(int kind, int first, int second, int third)
{
  constexpr double weights[3][3] = { { 1., -1., -1. }, { 0., 1., 0. }, { 0., 0., 1. } };
  const int corners[3] = { first % 3, second % 3, third % 3 };
  PatchPolynomial sum{};
  for (const Monomial& term : Quartics[kind])
  {
    PatchPolynomial product{};
    product[0] = term.Factor / 12.;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double* weight = weights[corners[i]];
      for (int n = 0; n < term.Powers[i]; ++n)
      {
        product = MultiplyByLinear(PatchPowers::Quartic, product, weight[0], weight[1], weight[2]);
      }
    }
    for (std::size_t p = 0; p < QuarticPowers; ++p)
    {
      sum[p] += product[p];
    }
  }
  return sum;
}

std::vector<PatchPolynomial> ListQuartics()
{
  std::vector<PatchPolynomial> all;
  for (int kind = 0; kind < 2; ++kind)
  {
    for (int k = 0; k < 3; ++k)
    {
      all.push_back(Expand(kind, k, k + 1, k + 2));
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    all.push_back(Expand(2, k, k + 1, k + 2));
    all.push_back(Expand(2, k, k + 2, k + 1));
  }
  return all;
}

std::vector<PatchPolynomial> ListBicubics()
{
  constexpr double cubics[4][4] = { { 1., -3., 3., -1. }, { 4., 0., -6., 3. }, { 1., 3., 3., -3. },
    { 0., 0., 0., 1. } };
  std::vector<PatchPolynomial> all;
  for (const auto& ofV : cubics)
  {
    for (const auto& ofU : cubics)
    {
      PatchPolynomial polynomial{};
      for (int j = 0; j < 4; ++j)
      {
        for (int i = 0; i < 4; ++i)
        {
          polynomial[static_cast<std::size_t>(NumberPower(PatchPowers::Bicubic, i, j))] =
            ofU[i] * ofV[j] / 36.;
        }
      }
      all.push_back(polynomial);
    }
  }
  return all;
}

/// The parts of all polynomials by their powers.
PatchParts SumPolynomials(
  PatchPowers kind, const std::vector<PatchPolynomial>& polynomials, double u, double v)
{
  std::vector<double> table;
  for (std::size_t n = 0; n < static_cast<std::size_t>(CountPowers(kind)); ++n)
  {
    for (const PatchPolynomial& polynomial : polynomials)
    {
      table.push_back(polynomial[n]);
    }
  }
  PatchParts parts{};
  PlaceSums sums{};
  for (std::size_t p = 0; p < PlaceParts::Count; ++p)
  {
    sums[p] = parts[p].data();
  }
  SumPowers(kind, FindPatchPowers(kind, u, v, Directions), table.data(), polynomials.size(), sums);
  return parts;
}

}

TEST(BoxSplineWeights, IsItsPolynomials)
{
  const std::vector<PatchPolynomial> quartics = ListQuartics();
  const std::vector<PatchPolynomial> bicubics = ListBicubics();
  for (int i = 0; i <= 10; ++i)
  {
    for (int j = 0; j <= 10; ++j)
    {
      const double u = 0.1 * i;
      const double v = 0.1 * j;
      for (const bool isTriangle : { true, false })
      {
        if (isTriangle && i + j > 10)
        {
          continue;
        }
        PatchParts found{};
        isTriangle ? WeightBoxSpline(u, v, Directions, PlaceDerivatives::Second, found)
                   : WeightBicubic(u, v, Directions, PlaceDerivatives::Second, found);
        const PatchParts expected = isTriangle
          ? SumPolynomials(PatchPowers::Quartic, quartics, u, v)
          : SumPolynomials(PatchPowers::Bicubic, bicubics, u, v);
        const auto points = static_cast<std::size_t>(isTriangle ? BoxSplinePoints : BicubicPoints);
        for (std::size_t p = 0; p < PlaceParts::Count; ++p)
        {
          for (std::size_t c = 0; c < points; ++c)
          {
            EXPECT_NEAR(found[p][c], expected[p][c], p == PlaceParts::Value ? 1e-15 : 1e-13)
              << "part " << p << " of point " << c << " at " << u << ", " << v;
          }
        }
      }
    }
  }
}

/// Nothing is written to second derivatives that are not wanted; all else is the same.
TEST(BoxSplineWeights, FirstDerivativesAlone)
{
  for (const bool isTriangle : { true, false })
  {
    const auto weigh = isTriangle ? WeightBoxSpline : WeightBicubic;
    PatchParts all{};
    weigh(0.3, 0.2, Directions, PlaceDerivatives::Second, all);
    PatchParts some{};
    weigh(0.3, 0.2, Directions, PlaceDerivatives::First, some);
    for (std::size_t p = 0; p < PlaceParts::Count; ++p)
    {
      EXPECT_EQ(some[p], p < PlaceParts::Second ? all[p] : PatchParts::value_type{}) << p;
    }
  }
}

/// Points on the far side of a corner have no weight at it, not even by rounding: values there may
/// be infinite.
TEST(BoxSplineWeights, FarPointsHaveNoWeightAtCorners)
{
  constexpr double corners[3][2] = { { 0., 0. }, { 1., 0. }, { 0., 1. } };
  for (int k = 0; k < 3; ++k)
  {
    PatchParts parts{};
    WeightBoxSpline(corners[k][0], corners[k][1], Directions, PlaceDerivatives::Second, parts);
    int zeros = 0;
    for (int c = 0; c < BoxSplinePoints; ++c)
    {
      zeros += parts[PlaceParts::Value][static_cast<std::size_t>(c)] == 0. ? 1 : 0;
    }
    EXPECT_EQ(zeros, BoxSplinePoints - 7) << k;
    PatchParts bicubic{};
    const double v = k == 2 ? 1. : 0.;
    WeightBicubic(k == 0 ? 0. : 1., v, Directions, PlaceDerivatives::Second, bicubic);
    const auto& values = bicubic[PlaceParts::Value];
    EXPECT_EQ(std::count(values.begin(), values.end(), 0.), BicubicPoints - 9) << k;
  }
}
