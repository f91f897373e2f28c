// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPatchPowers.cxx
 * Polynomials of two variables: products, derivatives along directions that are not the axes, and
 * sums for any number of columns.
 */
#include "Precompiled.h"

#include "Core/Operators/PatchPowers.h"

using namespace subdivision;

namespace
{

constexpr PatchPowers Kinds[] = { PatchPowers::Quartic, PatchPowers::Bicubic };

/// The sum of all powers with their factors.
double Evaluate(PatchPowers kind, const PatchPolynomial& polynomial, double u, double v)
{
  double sum = 0.;
  for (int j = 0; j <= (kind == PatchPowers::Quartic ? 4 : 3); ++j)
  {
    for (int i = 0; i <= (kind == PatchPowers::Quartic ? 4 - j : 3); ++i)
    {
      sum += polynomial[NumberPower(kind, i, j)] * std::pow(u, i) * std::pow(v, j);
    }
  }
  return sum;
}

}

TEST(PatchPowers, ProductsOfLinearFunctions)
{
  for (const PatchPowers kind : Kinds)
  {
    PatchPolynomial polynomial{};
    polynomial[0] = 1.;
    double expected = 1.;
    const double u = 0.3;
    const double v = -0.7;
    for (int n = 0; n < 3; ++n)
    {
      polynomial = MultiplyByLinear(kind, polynomial, 1. + n, 2., -0.5 * n);
      expected *= 1. + n + 2. * u - 0.5 * n * v;
    }
    EXPECT_NEAR(Evaluate(kind, polynomial, u, v), expected, 1e-14);
  }
}

TEST(PatchPowers, DerivativesAlongDirectionsAndAllColumns)
{
  const PatchDirections directions{ { { { 2., -1. } }, { { 0.5, 3. } } } };
  constexpr double u = 0.31;
  constexpr double v = 0.23;
  for (const PatchPowers kind : Kinds)
  {
    const int powers = CountPowers(kind);
    for (const std::size_t columns : { 1, 3, 4, 7, 12 })
    {
      std::vector<double> table;
      for (std::size_t i = 0; i < static_cast<std::size_t>(powers) * columns; ++i)
      {
        table.push_back(std::sin(1. + 7. * static_cast<double>(i)));
      }
      std::vector<std::vector<double>> found(PlaceParts::Count, std::vector<double>(columns, 9.));
      std::array<double*, PlaceParts::Count> sums;
      for (int p = 0; p < PlaceParts::Count; ++p)
      {
        sums[p] = found[p].data();
      }
      SumPowers(kind, FindPatchPowers(kind, u, v, directions), table.data(), columns, sums);
      for (std::size_t c = 0; c < columns; ++c)
      {
        PatchPolynomial polynomial{};
        for (int n = 0; n < powers; ++n)
        {
          polynomial[n] = table[static_cast<std::size_t>(n) * columns + c];
        }
        const auto at = [&](double p, double q)
        {
          return Evaluate(kind, polynomial, u + p * directions[0][0] + q * directions[0][1],
            v + p * directions[1][0] + q * directions[1][1]);
        };
        constexpr double h = 1e-3;
        EXPECT_NEAR(found[PlaceParts::Value][c], at(0., 0.), 1e-14);
        EXPECT_NEAR(found[PlaceParts::First][c], (at(h, 0.) - at(-h, 0.)) / (2. * h), 1e-3);
        EXPECT_NEAR(found[PlaceParts::First + 1][c], (at(0., h) - at(0., -h)) / (2. * h), 1e-3);
        EXPECT_EQ(found[PlaceParts::First + 2][c], 0.);
        EXPECT_NEAR(
          found[PlaceParts::Second][c], (at(h, 0.) - 2. * at(0., 0.) + at(-h, 0.)) / (h * h), 1e-2);
        EXPECT_NEAR(found[PlaceParts::Mixed][c],
          (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4. * h * h), 1e-2);
        EXPECT_NEAR(found[PlaceParts::SecondOfSecond][c],
          (at(0., h) - 2. * at(0., 0.) + at(0., -h)) / (h * h), 1e-2);
      }
    }
  }
}
