// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Places/PatchWeights.h"

#include "Core/Operators/BoxSpline.h"

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
  void Evaluate(const PlaceAt& at, const PatchDirections& directions, PatchParts& parts) const
  {
    PlaceSums sums;
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      sums[p] = parts[p].data();
    }
    SumPowers(this->Kind, FindPatchPowers(this->Kind, at[0], at[1], directions),
      this->Factors.data(), this->Points, sums);
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

void WeightControlPoints(PolynomialDomain domain, const PlaceAt& at,
  const PatchDirections& directions, PlaceDerivatives derivatives, PatchParts& parts)
{
  static const PolynomialTable ofLine = MakeTableOfLine();
  switch (domain)
  {
    case PolynomialDomain::Line:
      ofLine.Evaluate(at, directions, parts);
      return;
    case PolynomialDomain::Triangle:
      WeightBoxSpline(at[0], at[1], directions, derivatives, parts);
      return;
    default:
      WeightBicubic(at[0], at[1], directions, derivatives, parts);
  }
}

PatchParts WeightCorners(int corners, const PlaceAt& at, const PatchDirections& directions)
{
  static const PolynomialTable tables[4] = { MakeTableOfCorners(1), MakeTableOfCorners(2),
    MakeTableOfCorners(3), MakeTableOfCorners(4) };
  PatchParts parts;
  tables[corners - 1].Evaluate(at, directions, parts);
  return parts;
}

}
