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

KeptOperator* OperatorCache::Find(
  const TopologyKey& key, const std::function<bool(const KeptOperator&)>& accept)
{
  for (const auto& kept : this->Operators)
  {
    if (!kept->Used && kept->Key == key && accept(*kept))
    {
      kept->Used = true;
      return kept.get();
    }
  }
  return nullptr;
}

const KeptOperator* OperatorCache::FindCells(
  const TopologyKey& key, const SimplexTuples& derived) const
{
  const auto found = std::find_if(this->Operators.begin(), this->Operators.end(),
    [&](const auto& kept)
    {
      return kept->Key.HasSameCells(key) &&
        std::equal(derived.Tuples, derived.Tuples + 3, kept->ControlDerived.Tuples);
    });
  return found == this->Operators.end() ? nullptr : found->get();
}

void OperatorCache::ForgetUnused()
{
  this->Operators.erase(std::remove_if(this->Operators.begin(), this->Operators.end(),
                          [](const auto& kept) { return !kept->Used; }),
    this->Operators.end());
  for (const auto& kept : this->Operators)
  {
    kept->Used = false;
  }
}

std::size_t OperatorCache::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& kept : this->Operators)
  {
    bytes += kept->Key.GetMemorySize() + (kept->Steps ? kept->Steps->GetMemorySize() : 0) +
      kept->ControlStrata.GetMemorySize() + kept->ManifoldDimensions.GetMemorySize();
  }
  return bytes;
}

}
