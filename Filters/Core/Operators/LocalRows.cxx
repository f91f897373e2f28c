// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/LocalRows.h"

#include <algorithm>
#include <numeric>

namespace subdivision
{

std::vector<double> LocalRows::Sum(const std::vector<double>& weights) const
{
  std::vector<double> sum(this->GetNumberOfItems(), 0.);
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    this->ForRow(i, [&](std::size_t column, double weight) { sum[column] += weights[i] * weight; });
  }
  return sum;
}

std::vector<double> LocalRows::Fill() const
{
  const std::size_t items = this->GetNumberOfItems();
  std::vector<double> matrix(items * items, 0.);
  for (std::size_t i = 0; i < items; ++i)
  {
    this->ForRow(
      i, [&](std::size_t column, double weight) { matrix[i * items + column] += weight; });
  }
  return matrix;
}

/// The algorithm of W. Grassmann, M. Taksar and D. Heyman (1985) subtracts nothing and so is exact
/// to rounding.
std::vector<double> LocalRows::Eliminate() const
{
  const int items = static_cast<int>(this->GetNumberOfItems());
  std::vector<double> a = this->Fill();
  for (int k = items - 1; k > 0; --k)
  {
    const double* last = a.data() + k * items;
    const double sum = std::accumulate(last, last + k, 0.);
    for (int i = 0; i < k; ++i)
    {
      const double factor = a[i * items + k] /= sum;
      for (int j = 0; factor != 0. && j < k; ++j)
      {
        a[i * items + j] += factor * last[j];
      }
    }
  }
  std::vector<double> w(items, 0.);
  w[0] = 1.;
  for (int k = 1; k < items; ++k)
  {
    for (int i = 0; i < k; ++i)
    {
      w[k] += w[i] * a[i * items + k];
    }
  }
  return w;
}

/// The weights by the series of LimitStencils.h, not normalised.
std::vector<double> LocalRows::SumSeries() const
{
  const std::size_t items = this->GetNumberOfItems();
  std::vector<double> sum(items, 0.);
  std::vector<double> term(items, 0.);
  std::vector<double> next(items);
  this->ForRow(0, [&](std::size_t item, double weight) { term[item] += weight; });
  double total = 1.;
  for (double left = 1.; left > 1e-20 * total; total += left)
  {
    left = 0.;
    std::fill(next.begin(), next.end(), 0.);
    for (std::size_t i = 1; i < items; ++i)
    {
      sum[i] += term[i];
      left += term[i];
      this->ForRow(i, [&](std::size_t item, double weight) { next[item] += term[i] * weight; });
    }
    term.swap(next);
  }
  sum[0] = 1.;
  return sum;
}

std::vector<double> LocalRows::FindLimit() const
{
  std::vector<double> w = this->GetNumberOfItems() <= 48 ? this->Eliminate() : this->SumSeries();
  const double total = std::accumulate(w.begin(), w.end(), 0.);
  for (double& weight : w)
  {
    weight /= total;
  }
  return w;
}

}
