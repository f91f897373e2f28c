// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PatchPolynomials.h"

#include "Core/Operators/BlockOperator.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

struct Power
{
  int U;
  int V;
};

constexpr int Degree = LatticeSize;

/// The number of a power.
constexpr int Number(int u, int v)
{
  return v * (Degree + 1) - v * (v - 1) / 2 + u;
}

std::array<Power, PatchPowers> ListPowers()
{
  std::array<Power, PatchPowers> powers{};
  for (int v = 0; v <= Degree; ++v)
  {
    for (int u = 0; u + v <= Degree; ++u)
    {
      powers[Number(u, v)] = { u, v };
    }
  }
  return powers;
}

using Polynomial = std::array<double, PatchPowers>;

/// Multiplies by a + b u + c v what has a degree below the highest.
Polynomial Multiply(const Polynomial& polynomial, double a, double b, double c)
{
  Polynomial product{};
  for (int v = 0; v <= Degree; ++v)
  {
    for (int u = 0; u + v <= Degree; ++u)
    {
      const double value = polynomial[Number(u, v)];
      product[Number(u, v)] += a * value;
      if (u + v < Degree)
      {
        product[Number(u + 1, v)] += b * value;
        product[Number(u, v + 1)] += c * value;
      }
    }
  }
  return product;
}

/// Coefficients of regular patches are multiples of 1/24, whose last digits got lost in sums.
double Sharpen(double coefficient)
{
  const double sharp = std::round(24. * coefficient) / 24.;
  return std::abs(sharp - coefficient) < 1e-13 ? sharp : coefficient;
}

/// The polynomial that is 1 at a node of the lattice and 0 at all others: integers, divided once.
Polynomial ExpandNode(const PlaceNode& node)
{
  const double weights[3][3] = { { 1., -1., -1. }, { 0., 1., 0. }, { 0., 0., 1. } };
  Polynomial polynomial{};
  polynomial[0] = 1.;
  double divisor = 1.;
  for (int i = 0; i < 3; ++i)
  {
    for (int r = 0; r < node[i]; ++r)
    {
      polynomial = Multiply(polynomial, LatticeSize * weights[i][0] - r,
        LatticeSize * weights[i][1], LatticeSize * weights[i][2]);
      divisor *= r + 1;
    }
  }
  for (double& value : polynomial)
  {
    value /= divisor;
  }
  return polynomial;
}

}

std::array<std::array<double, PatchPowers>, PlaceParts::Count> FindPatchPowers(
  const CornerWeights& at, const std::array<CornerWeights, 3>& directions)
{
  static const std::array<Power, PatchPowers> powers = ListPowers();
  // powers of u and v, and their derivatives
  double of[2][3][Degree + 1];
  for (int k = 0; k < 2; ++k)
  {
    double value = 1.;
    for (int n = 0; n <= Degree; ++n)
    {
      of[k][0][n] = value;
      of[k][1][n] = n > 0 ? n * of[k][0][n - 1] : 0.;
      of[k][2][n] = n > 1 ? n * (n - 1) * of[k][0][n - 2] : 0.;
      value *= at[k + 1];
    }
  }
  const CornerWeights& first = directions[0];
  const CornerWeights& second = directions[1];
  std::array<std::array<double, PatchPowers>, PlaceParts::Count> parts{};
  for (int p = 0; p < PatchPowers; ++p)
  {
    const auto find = [&](int ofU, int ofV)
    { return of[0][ofU][powers[p].U] * of[1][ofV][powers[p].V]; };
    const double u = find(1, 0);
    const double v = find(0, 1);
    const double uu = find(2, 0);
    const double uv = find(1, 1);
    const double vv = find(0, 2);
    const auto differentiate = [&](const CornerWeights& a, const CornerWeights& b)
    { return a[1] * b[1] * uu + (a[1] * b[2] + a[2] * b[1]) * uv + a[2] * b[2] * vv; };
    parts[PlaceParts::Value][p] = find(0, 0);
    parts[PlaceParts::First][p] = first[1] * u + first[2] * v;
    parts[PlaceParts::First + 1][p] = second[1] * u + second[2] * v;
    parts[PlaceParts::Second][p] = differentiate(first, first);
    parts[PlaceParts::Mixed][p] = differentiate(first, second);
    parts[PlaceParts::SecondOfSecond][p] = differentiate(second, second);
  }
  return parts;
}

const std::vector<double>& PatchPolynomials::Find(const SheetKey& key)
{
  std::vector<double>& found = this->Found[key.Pack()];
  if (found.empty())
  {
    const std::vector<double>& rows = this->Rows.Find(key);
    const std::vector<PlaceNode>& nodes =
      ListLattice(key.Places == SheetPlaces::FaceLattice ? 2 : 1);
    const std::size_t columns = rows.size() / nodes.size();
    found.assign(PatchPowers * columns, 0.);
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      const Polynomial polynomial = ExpandNode(nodes[n]);
      for (int p = 0; p < PatchPowers; ++p)
      {
        for (std::size_t c = 0; c < columns; ++c)
        {
          found[p * columns + c] += polynomial[p] * rows[n * columns + c];
        }
      }
    }
    std::transform(found.begin(), found.end(), found.begin(), Sharpen);
  }
  return found;
}

const SparseRows<int>& PatchPolynomials::FindSparse(const SheetKey& key)
{
  const auto [found, isNew] = this->Sparse.try_emplace(key.Pack());
  if (isNew)
  {
    const std::vector<double>& weights = this->Find(key);
    const auto columns = static_cast<vtkIdType>(weights.size()) / PatchPowers;
    const auto append = [&](vtkIdType begin, vtkIdType end, RowBlock<int>& rows)
    {
      for (vtkIdType power = begin; power < end; ++power)
      {
        for (vtkIdType k = 0; k < columns; ++k)
        {
          const double weight = weights[power * columns + k];
          weight != 0. ? rows.Add(static_cast<int>(k), weight) : void();
        }
        rows.EndRow();
      }
    };
    found->second = BlockOperator<int>(columns, PatchPowers, append).Store();
  }
  return found->second;
}

}
