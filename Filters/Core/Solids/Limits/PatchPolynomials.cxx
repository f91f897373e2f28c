// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PatchPolynomials.h"

#include "Core/Operators/BlockOperator.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Coefficients over whole simplices, which are regular, are multiples of 1/24, whose last digits
/// got lost in sums.
double Sharpen(double coefficient)
{
  const double sharp = std::round(24. * coefficient) / 24.;
  return std::abs(sharp - coefficient) < 1e-13 ? sharp : coefficient;
}

}

const std::vector<double>& PatchPolynomials::Find(const SheetKey& key)
{
  std::vector<double>& found = this->Found[key.Pack()];
  if (found.empty())
  {
    found = this->Rows.Find(key);
    if (key.Part == 1)
    {
      std::transform(found.begin(), found.end(), found.begin(), Sharpen);
    }
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
