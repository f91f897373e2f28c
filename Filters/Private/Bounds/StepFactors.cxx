// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/StepFactors.h"

#include <utility>

namespace subdivision
{

Sectors::Step ListFactors(const MatrixFactors& factors, std::size_t first, std::size_t last)
{
  Sectors::Step step;
  for (std::size_t operation = first; operation < last; ++operation)
  {
    const MatrixFactors::Operation& its = factors.GetOperations()[operation];
    for (std::size_t f = its.Begin; f < its.End; ++f)
    {
      step.push_back(&factors.Get()[f]);
    }
  }
  return step;
}

Buffer<double> ApplyFactors(
  const Sectors::Step& factors, const Buffer<double>& values, int components)
{
  if (factors.empty())
  {
    Buffer<double> copy(values.size());
    CopyInThreads(values.data(), values.size(), copy.data());
    return copy;
  }
  Buffer<double> result;
  for (const MatrixFactors::Matrix* factor : factors)
  {
    Buffer<double> next(components * factor->GetNumberOfRows());
    factor->Apply(
      factor == factors.front() ? values.data() : result.data(), next.data(), components);
    result = std::move(next);
  }
  return result;
}

}
