// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/OperatorCache.h"

#include <algorithm>

namespace subdivision
{

std::size_t TopologyKey::GetMemorySize() const
{
  return this->Simplices.Dimensions.size() +
    sizeof(vtkIdType) * (this->Simplices.Connectivity.size() + this->Choices.size());
}

std::size_t KeptOperator::GetMemorySize() const
{
  return this->Key.GetMemorySize() + (this->Steps ? this->Steps->GetMemorySize() : 0) +
    this->ControlStrata.GetMemorySize() + this->ManifoldDimensions.GetMemorySize();
}

const KeptOperator* OperatorCache::FindCells(
  const TopologyKey& key, const SimplexTuples& derived) const
{
  return this->Find(
    [&](const KeptOperator& kept)
    {
      return kept.Key.HasSameCells(key) &&
        std::equal(derived.Tuples, derived.Tuples + 3, kept.ControlDerived.Tuples);
    });
}

}
