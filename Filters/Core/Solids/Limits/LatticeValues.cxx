// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LatticeValues.h"

#include "Core/Memory/Ids.h"

#include <algorithm>
#include <limits>

namespace subdivision
{
namespace
{

/// The first level, but not the control level, that has a vertex with some weights, none of which
/// is negative; they become multiples of 1/2^level. -1: there is none.
int FindLatticeLevel(const std::array<double, 3>& at, LatticeWeights& weights)
{
  constexpr long long all = 1ll << MostLatticeLevels;
  long long sum = 0;
  long long bits = 0;
  for (int i = 0; i < 3; ++i)
  {
    if (!(at[i] >= 0. && at[i] <= 1.))
    {
      return -1;
    }
    weights[i] = static_cast<long long>(static_cast<double>(all) * at[i]);
    sum += weights[i];
    bits |= weights[i];
  }
  int zeros = 0; // at the end of all weights, but not those that lead to the control level
  for (int more = 32; more > 0; more /= 2)
  {
    const long long last = (1ll << more) - 1;
    if (zeros + more < MostLatticeLevels && (bits >> zeros & last) == 0)
    {
      zeros += more;
    }
  }
  for (long long& weight : weights)
  {
    weight >>= zeros;
  }
  return sum == all ? MostLatticeLevels - zeros : -1;
}

}

template <typename Id>
void LatticeValues<Id>::FindLimit(
  int dimension, Id simplex, const std::array<double, 3>& at, const double* control, double* limit)
{
  this->Control = control;
  LatticeWeights weights{};
  const int level = FindLatticeLevel(at, weights);
  const bool isKnown = level > 0 &&
    this->Lattice.ReadLimit(this->Lattice.Find(dimension, simplex, weights), this->Limit);
  std::fill_n(limit, this->Components, isKnown ? 0. : std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; isKnown && k < this->Limit.Vertices.size(); ++k)
  {
    const double* value = this->Find(this->Limit.Vertices[k], level);
    for (int c = 0; c < this->Components; ++c)
    {
      limit[c] += this->Limit.Weights[k] * value[c];
    }
  }
}

template <typename Id>
const double* LatticeValues<Id>::Find(const LatticeVertex<Id>& vertex, int level)
{
  if (level == 0)
  {
    return this->Control + vtkIdType(this->Components) * vertex.GetColumn();
  }
  LevelValues& on = this->Levels[static_cast<std::size_t>(level)];
  const auto size = static_cast<std::size_t>(this->Components);
  const std::size_t first = size * on.Numbers.GetNumber(vertex);
  if (first < on.Values.size())
  {
    return on.Values.data() + first;
  }
  ++this->Size;
  const bool isKnown = this->Lattice.ReadRow(vertex, on.Row);
  on.Values.resize(first + size, isKnown ? 0. : std::numeric_limits<double>::quiet_NaN());
  double* sums = on.Values.data() + first; // stays: sums are over values of earlier levels
  for (std::size_t k = 0; isKnown && k < on.Row.Vertices.size(); ++k)
  {
    const double* value = this->Find(on.Row.Vertices[k], level - 1);
    for (std::size_t c = 0; c < size; ++c)
    {
      sums[c] += on.Row.Weights[k] * value[c];
    }
  }
  return sums;
}

template <typename Id>
void LatticeValues<Id>::Clear()
{
  for (LevelValues& on : this->Levels)
  {
    on = LevelValues();
  }
  this->Size = 0;
}

SUBDIVISION_COMPILE(class LatticeValues);

}
