// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PatchPolynomials.h"

#include "Core/Operators/BlockOperator.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Coefficients of regular patches are multiples of 1/24, whose last digits got lost in sums.
double Sharpen(double coefficient)
{
  const double sharp = std::round(24. * coefficient) / 24.;
  return std::abs(sharp - coefficient) < 1e-13 ? sharp : coefficient;
}

/// The polynomial that is 1 at a node of the lattice and 0 at all others: integers, divided once.
PatchPolynomial ExpandNode(const PlaceNode& node)
{
  const double weights[3][3] = { { 1., -1., -1. }, { 0., 1., 0. }, { 0., 0., 1. } };
  PatchPolynomial polynomial{};
  polynomial[0] = 1.;
  double divisor = 1.;
  for (int i = 0; i < 3; ++i)
  {
    for (int r = 0; r < node[i]; ++r)
    {
      polynomial = MultiplyByLinear(PatchPowers::Quartic, polynomial,
        LatticeSize * weights[i][0] - r, LatticeSize * weights[i][1], LatticeSize * weights[i][2]);
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

const std::vector<double>& PatchPolynomials::Find(const SheetKey& key)
{
  std::vector<double>& found = this->Found[key.Pack()];
  if (found.empty())
  {
    const std::vector<double>& rows = this->Rows.Find(key);
    const std::vector<PlaceNode>& nodes =
      ListLattice(key.Places == SheetPlaces::FaceLattice ? 2 : 1);
    const std::size_t columns = rows.size() / nodes.size();
    // Without the row of the first node, which all polynomials of the nodes together multiply by 1:
    // what is left is small in a small part, and its rounding too.
    found.assign(QuarticPowers * columns, 0.);
    std::copy_n(rows.begin(), columns, found.begin());
    for (std::size_t n = 1; n < nodes.size(); ++n)
    {
      const PatchPolynomial polynomial = ExpandNode(nodes[n]);
      for (int p = 0; p < QuarticPowers; ++p)
      {
        for (std::size_t c = 0; c < columns; ++c)
        {
          found[p * columns + c] += polynomial[p] * (rows[n * columns + c] - rows[c]);
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
    const auto columns = static_cast<vtkIdType>(weights.size()) / QuarticPowers;
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
    found->second = BlockOperator<int>(columns, QuarticPowers, append).Store();
  }
  return found->second;
}

}
