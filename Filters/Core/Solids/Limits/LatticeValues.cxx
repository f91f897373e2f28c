// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LatticeValues.h"

#include "Core/Memory/Ids.h"

#include <algorithm>
#include <limits>

namespace subdivision
{

template <typename LevelType>
void LatticeValues<LevelType>::FindLimit(
  const LatticeVertex<Id>& vertex, int level, const double* control, double* limit)
{
  this->Control = control;
  while (static_cast<int>(this->Levels.size()) <= level)
  {
    this->Levels.emplace_back();
  }
  const bool isKnown = this->Lattice->ReadLimit(vertex, this->Limit);
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

template <typename LevelType>
const double* LatticeValues<LevelType>::Find(const LatticeVertex<Id>& vertex, int level)
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
  const bool isKnown = this->Lattice->ReadRow(vertex, on.Row);
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

template <typename LevelType>
void LatticeValues<LevelType>::Clear()
{
  this->Levels.clear();
  this->Size = 0;
}

template class LatticeValues<Level<int>>;
template class LatticeValues<Level<long long>>;
template class LatticeValues<TetOctLevel<int>>;
template class LatticeValues<TetOctLevel<long long>>;

}
