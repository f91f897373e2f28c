// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Places/PatchWeights.h"

#include <cstddef>
#include <vector>

namespace subdivision
{
namespace
{

/// One polynomial for each point.
struct PolynomialTable
{
  PatchPowers Kind = PatchPowers::Quartic;
  std::size_t Points = 0;
  std::vector<double> Factors; ///< of all points for the first power, for the second, ...

  explicit PolynomialTable(const std::vector<PatchPolynomial>& polynomials,
    PatchPowers kind = PatchPowers::Quartic, double divisor = 1.)
    : Kind(kind)
    , Points(polynomials.size())
  {
    for (int power = 0; power < CountPowers(kind); ++power)
    {
      for (const PatchPolynomial& polynomial : polynomials)
      {
        this->Factors.push_back(polynomial[power] / divisor);
      }
    }
  }
  PatchParts Evaluate(const PlaceAt& at, const PatchDirections& directions) const
  {
    PatchParts parts;
    std::array<double*, PlaceParts::Count> sums;
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      sums[p] = parts[p].data();
    }
    SumPowers(this->Kind, FindPatchPowers(this->Kind, at[0], at[1], directions),
      this->Factors.data(), this->Points, sums);
    return parts;
  }
};

/// The uniform cubic B-splines that are not zero in [0, 1], times 6, by powers.
constexpr double Cubics[4][4] = { { 1., -3., 3., -1. }, { 4., 0., -6., 3. }, { 1., 3., 3., -3. },
  { 0., 0., 0., 1. } };

PolynomialTable MakeTableOfLine()
{
  std::vector<PatchPolynomial> all;
  for (const auto& cubic : Cubics)
  {
    PatchPolynomial polynomial{};
    for (int i = 0; i < 4; ++i)
    {
      polynomial[NumberPower(PatchPowers::Quartic, i, 0)] = cubic[i];
    }
    all.push_back(polynomial);
  }
  return PolynomialTable(all, PatchPowers::Quartic, 6.);
}

PolynomialTable MakeTableOfQuad()
{
  std::vector<PatchPolynomial> all;
  for (const auto& ofY : Cubics)
  {
    for (const auto& ofX : Cubics)
    {
      PatchPolynomial polynomial{};
      for (int j = 0; j < 4; ++j)
      {
        for (int i = 0; i < 4; ++i)
        {
          polynomial[NumberPower(PatchPowers::Bicubic, i, j)] = ofX[i] * ofY[j];
        }
      }
      all.push_back(polynomial);
    }
  }
  return PolynomialTable(all, PatchPowers::Bicubic, 36.);
}

/// A term of a quartic polynomial in the weights of three corners.
struct Monomial
{
  double Factor;
  std::array<int, 3> Powers;
};

/// The polynomials of the box spline over a triangle, times 12, by where their control point is: at
/// the first corner; beyond the edge from the first to the second; next to that, at the first.
const std::vector<Monomial>& GetQuartic(int kind)
{
  static const std::vector<Monomial> quartics[3] = {
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
  return quartics[kind];
}

/// One of the quartics, with the corners in the given order.
PatchPolynomial ExpandQuartic(int kind, const std::array<int, 3>& corners)
{
  constexpr double weights[3][3] = { { 1., -1., -1. }, { 0., 1., 0. }, { 0., 0., 1. } };
  PatchPolynomial sum{};
  for (const Monomial& term : GetQuartic(kind))
  {
    PatchPolynomial product{};
    product[0] = term.Factor;
    for (int i = 0; i < 3; ++i)
    {
      const double* weight = weights[corners[i]];
      for (int n = 0; n < term.Powers[i]; ++n)
      {
        product = MultiplyByLinear(PatchPowers::Quartic, product, weight[0], weight[1], weight[2]);
      }
    }
    for (int p = 0; p < QuarticPowers; ++p)
    {
      sum[p] += product[p];
    }
  }
  return sum;
}

PolynomialTable MakeTableOfTriangle()
{
  std::vector<PatchPolynomial> all;
  for (int kind = 0; kind < 2; ++kind)
  {
    for (int k = 0; k < 3; ++k)
    {
      all.push_back(ExpandQuartic(kind, { { k, (k + 1) % 3, (k + 2) % 3 } }));
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    all.push_back(ExpandQuartic(2, { { k, (k + 1) % 3, (k + 2) % 3 } }));
    all.push_back(ExpandQuartic(2, { { k, (k + 2) % 3, (k + 1) % 3 } }));
  }
  return PolynomialTable(all, PatchPowers::Quartic, 12.);
}

/// The functions that are 1 at one corner: a + b x + c y + d x y.
PolynomialTable MakeTableOfCorners(int corners)
{
  constexpr double ofQuad[4][4] = { { 1., -1., -1., 1. }, { 0., 1., 0., -1. }, { 0., 0., 0., 1. },
    { 0., 0., 1., -1. } };
  constexpr double ofTriangle[3][4] = { { 1., -1., -1., 0. }, { 0., 1., 0., 0. },
    { 0., 0., 1., 0. } };
  constexpr double ofLine[2][4] = { { 1., -1., 0., 0. }, { 0., 1., 0., 0. } };
  constexpr double ofVertex[1][4] = { { 1., 0., 0., 0. } };
  const auto* functions = corners == 1 ? ofVertex
    : corners == 2                     ? ofLine
    : corners == 3                     ? ofTriangle
                                       : ofQuad;
  std::vector<PatchPolynomial> all;
  for (int k = 0; k < corners; ++k)
  {
    PatchPolynomial polynomial{};
    for (int n = 0; n < 4; ++n)
    {
      polynomial[NumberPower(PatchPowers::Bicubic, n % 2, n / 2)] = functions[k][n];
    }
    all.push_back(polynomial);
  }
  return PolynomialTable(all, PatchPowers::Bicubic);
}

}

PatchParts WeightControlPoints(
  PolynomialDomain domain, const PlaceAt& at, const PatchDirections& directions)
{
  static const PolynomialTable tables[3] = { MakeTableOfLine(), MakeTableOfTriangle(),
    MakeTableOfQuad() };
  return tables[static_cast<int>(domain)].Evaluate(at, directions);
}

PatchParts WeightCorners(int corners, const PlaceAt& at, const PatchDirections& directions)
{
  static const PolynomialTable tables[4] = { MakeTableOfCorners(1), MakeTableOfCorners(2),
    MakeTableOfCorners(3), MakeTableOfCorners(4) };
  return tables[corners - 1].Evaluate(at, directions);
}

}
