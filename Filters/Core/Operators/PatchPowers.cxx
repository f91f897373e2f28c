// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/PatchPowers.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Calls act(number, i, j) for each power.
template <typename Act>
void ForPowers(PatchPowers kind, const Act& act)
{
  const bool isQuartic = kind == PatchPowers::Quartic;
  int number = 0;
  for (int j = 0; j <= (isQuartic ? 4 : 3); ++j)
  {
    for (int i = 0; i <= (isQuartic ? 4 - j : 3); ++i)
    {
      act(number++, i, j);
    }
  }
}

/// The powers that count at a place, and their weights.
struct Terms
{
  int Size = 0;
  std::array<int, MostPatchPowers> Rows;
  std::array<double, MostPatchPowers> Weights;
};

/// Sums of `Size` columns side by side, which stay in registers.
template <std::size_t Size>
void SumColumns(const Terms& terms, const double* from, std::size_t columns, double* sums)
{
  std::array<double, Size> sum{};
  for (int k = 0; k < terms.Size; ++k)
  {
    const double weight = terms.Weights[k];
    const double* row = from + static_cast<std::size_t>(terms.Rows[k]) * columns;
    for (std::size_t c = 0; c < Size; ++c)
    {
      sum[c] += weight * row[c];
    }
  }
  std::copy(sum.begin(), sum.end(), sums);
}

}

PatchPolynomial MultiplyByLinear(
  PatchPowers kind, const PatchPolynomial& polynomial, double a, double b, double c)
{
  PatchPolynomial product{};
  const bool isQuartic = kind == PatchPowers::Quartic;
  ForPowers(kind,
    [&](int number, int i, int j)
    {
      const double value = polynomial[number];
      product[number] += a * value;
      if (isQuartic ? i + j < 4 : i < 3)
      {
        product[NumberPower(kind, i + 1, j)] += b * value;
      }
      if (isQuartic ? i + j < 4 : j < 3)
      {
        product[NumberPower(kind, i, j + 1)] += c * value;
      }
    });
  return product;
}

PatchParts FindPatchPowers(PatchPowers kind, double u, double v, const PatchDirections& directions)
{
  constexpr int degree = 4;
  double of[2][3][degree + 1]; // powers of u and v, and their derivatives
  for (int k = 0; k < 2; ++k)
  {
    double value = 1.;
    for (int n = 0; n <= degree; ++n)
    {
      of[k][0][n] = value;
      of[k][1][n] = n > 0 ? n * of[k][0][n - 1] : 0.;
      of[k][2][n] = n > 1 ? n * (n - 1) * of[k][0][n - 2] : 0.;
      value *= k == 0 ? u : v;
    }
  }
  const auto& ofU = directions[0]; // a structured binding cannot be captured
  const auto& ofV = directions[1];
  PatchParts parts{};
  ForPowers(kind,
    [&](int number, int i, int j)
    {
      const double byU = of[0][1][i] * of[1][0][j];
      const double byV = of[0][0][i] * of[1][1][j];
      const double byUU = of[0][2][i] * of[1][0][j];
      const double byUV = of[0][1][i] * of[1][1][j];
      const double byVV = of[0][0][i] * of[1][2][j];
      const auto second = [&](int p, int q)
      {
        return ofU[p] * ofU[q] * byUU + (ofU[p] * ofV[q] + ofV[p] * ofU[q]) * byUV +
          ofV[p] * ofV[q] * byVV;
      };
      parts[PlaceParts::Value][number] = of[0][0][i] * of[1][0][j];
      for (int p = 0; p < 2; ++p)
      {
        parts[PlaceParts::First + p][number] = ofU[p] * byU + ofV[p] * byV;
      }
      parts[PlaceParts::Second][number] = second(0, 0);
      parts[PlaceParts::Mixed][number] = second(0, 1);
      parts[PlaceParts::SecondOfSecond][number] = second(1, 1);
    });
  return parts;
}

void SumPowers(PatchPowers kind, const PatchParts& powers, const double* polynomials,
  std::size_t columns, const PlaceSums& sums)
{
  const int size = CountPowers(kind);
  for (int p = 0; p < PlaceParts::Count; ++p)
  {
    if (!sums[p])
    {
      continue;
    }
    Terms terms;
    for (int n = 0; n < size; ++n)
    {
      terms.Rows[terms.Size] = n;
      terms.Weights[terms.Size] = powers[p][n];
      terms.Size += powers[p][n] != 0. ? 1 : 0;
    }
    std::size_t c = 0;
    for (; c + 12 <= columns; c += 12) // of a regular triangle
    {
      SumColumns<12>(terms, polynomials + c, columns, sums[p] + c);
    }
    for (; c + 4 <= columns; c += 4)
    {
      SumColumns<4>(terms, polynomials + c, columns, sums[p] + c);
    }
    for (; c < columns; ++c)
    {
      SumColumns<1>(terms, polynomials + c, columns, sums[p] + c);
    }
  }
}

}
