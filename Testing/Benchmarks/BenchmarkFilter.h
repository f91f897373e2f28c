// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkFilter.h
 * The filter as it is measured.
 */
#ifndef SubdivisionObjects_BenchmarkFilter_h
#define SubdivisionObjects_BenchmarkFilter_h

#include "BenchmarkMeshes.h"

#include "vtkMultiDimensionalSubdivision.h"

namespace benchmarks
{

/// Turns the operator cache on or off, in versions of the filter that have one.
template <typename Filter>
auto SetCache(Filter* filter, bool on, int) -> decltype(filter->SetCacheOperator(on))
{
  return filter->SetCacheOperator(on);
}
template <typename Filter>
void SetCache(Filter*, bool, long)
{
}

/// A fresh filter on the input of a case.
vtkSmartPointer<vtkMultiDimensionalSubdivision> MakeFilter(
  const Case& which, int levels, bool cache);

}

#endif
