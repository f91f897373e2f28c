// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PatchTree.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace subdivision
{
namespace
{

bool IsRegularFan(const SheetFan& fan)
{
  return (fan.What == SheetFan::Kind::Closed && fan.After == 4) ||
    (fan.What == SheetFan::Kind::Open && fan.After + fan.Before == 2);
}

/// Whether the limit over the whole simplex is one polynomial.
bool IsPolynomial(const SheetKey& key)
{
  return key.Places == SheetPlaces::Curve ||
    std::all_of(key.Fans.begin(), key.Fans.end(), IsRegularFan);
}

/// The child of a face with a place, and the weights of its corners. The middle one comes first
/// where two share the place.
int GoToChild(std::array<double, 3>& at)
{
  for (int child = 0; child < 3; ++child)
  {
    if (at[child] > 0.5)
    {
      const int next = (child + 1) % 3;
      const int last = (child + 2) % 3;
      at[next] *= 2.;
      at[last] *= 2.;
      at[child] = 2. * at[child] - 1.;
      return child;
    }
  }
  at = { { 1. - 2. * at[2], 1. - 2. * at[0], 1. - 2. * at[1] } };
  return 3;
}

/// The sum of the powers u^i v^j with i + j <= 4, those without v first, with values.
template <typename Size>
void Evaluate(const double* powers, double u, double v, double* sums, Size size)
{
  const auto sum = [&](int first, int degree, std::size_t c)
  {
    double value = 0.;
    for (int k = degree; k >= 0; --k)
    {
      value = value * u + powers[static_cast<std::size_t>(first + k) * size + c];
    }
    return value;
  };
  for (std::size_t c = 0; c < size; ++c)
  {
    sums[c] = sum(0, 4, c) +
      v * (sum(5, 3, c) + v * (sum(9, 2, c) + v * (sum(12, 1, c) + v * sum(14, 0, c))));
  }
}

}

double* PatchTree::Start(const SheetKey& key, std::size_t columns, const std::array<int, 3>& order)
{
  this->Nodes.clear();
  this->Values.clear();
  this->Powers.clear();
  this->Order = order;
  this->Add(key, columns);
  return this->Values.data();
}

int PatchTree::Add(const SheetKey& key, std::size_t columns)
{
  Node node;
  node.Key = key;
  node.Columns = columns;
  node.Values = this->Values.size();
  node.IsRegular = IsPolynomial(key);
  this->Values.resize(node.Values + columns * this->Components, 0.);
  this->Nodes.push_back(node);
  return static_cast<int>(this->Nodes.size()) - 1;
}

/// Calls act(number of components), which is a constant if that is 3.
template <typename Act>
void PatchTree::WithSize(const Act& act) const
{
  this->Components == 3 ? act(std::integral_constant<std::size_t, 3>()) : act(this->Components);
}

template <typename Size>
void PatchTree::SumRows(const SparseRows<int>& rows, const double* from, double* to, Size size)
{
  for (vtkIdType row = 0; row < rows.GetNumberOfRows(); ++row, to += size)
  {
    for (int k = rows.Offsets[row]; k < rows.Offsets[row + 1]; ++k)
    {
      const double weight = rows.Weights[k];
      const double* value = from + size * static_cast<std::size_t>(rows.Columns[k]);
      for (std::size_t c = 0; c < size; ++c)
      {
        to[c] += weight * value[c];
      }
    }
  }
}

/// The number of a child; -1 if it is no sheet.
int PatchTree::GetChild(int parent, int child)
{
  if (this->Nodes[parent].Children[child] < 0)
  {
    const SheetChild& found = this->Polynomials.FindChild(this->Nodes[parent].Key, child);
    if (found.Rows.GetNumberOfRows() == 0)
    {
      return -1;
    }
    const int added = this->Add(found.Key, static_cast<std::size_t>(found.Rows.GetNumberOfRows()));
    double* values = this->Values.data();
    this->WithSize(
      [&](auto size)
      {
        SumRows(found.Rows, values + this->Nodes[parent].Values, values + this->Nodes[added].Values,
          size);
      });
    this->Nodes[parent].Children[child] = added;
  }
  return this->Nodes[parent].Children[child];
}

void PatchTree::MakePowers(Node& node)
{
  const std::size_t first = this->Powers.size();
  this->Powers.resize(first + QuarticPowers * this->Components, 0.);
  const SparseRows<int>& rows = this->Polynomials.FindSparse(node.Key);
  this->WithSize([&](auto size)
    { SumRows(rows, this->Values.data() + node.Values, this->Powers.data() + first, size); });
  node.Powers = static_cast<std::ptrdiff_t>(first);
}

void PatchTree::Find(const std::array<double, 3>& at, double* limit)
{
  std::fill_n(limit, this->Components, std::numeric_limits<double>::quiet_NaN());
  std::array<double, 3> weights;
  std::transform(this->Order.begin(), this->Order.end(), weights.begin(),
    [&at](int corner) { return at[corner]; });
  int number = 0;
  for (int splits = 0; !this->Nodes[number].IsRegular; ++splits)
  {
    number = this->GetChild(number, GoToChild(weights));
    if (number < 0 || splits == MostSplits)
    {
      return;
    }
  }
  Node& node = this->Nodes[number];
  if (node.Powers < 0)
  {
    this->MakePowers(node);
  }
  this->WithSize([&](auto size)
    { Evaluate(this->Powers.data() + node.Powers, weights[1], weights[2], limit, size); });
}

}
