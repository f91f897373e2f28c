// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OperatorCacheTools.h
 * A filter that is executed again and again, and what its outputs share.
 */
#ifndef SubdivisionObjects_OperatorCacheTools_h
#define SubdivisionObjects_OperatorCacheTools_h

#include "FeatureTools.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

namespace operator_cache_tools
{

using namespace feature_tools;

/// A filter that stays, and the messages it may not give.
class Kept
{
public:
  explicit Kept(const Configure& configure = {});
  ~Kept();
  Filter* operator->() { return this->Cached; }
  Filter* Get() { return this->Cached; }
  /// A copy of the output that shares its arrays.
  Grid Update(vtkDataObject* input);
  /// How often topology was built since the last question.
  vtkIdType CountBuilds()
  {
    const vtkIdType before = this->Counted;
    this->Counted = this->Cached->GetNumberOfTopologyBuilds();
    return this->Counted - before;
  }

private:
  vtkNew<Filter> Cached;
  vtkNew<Messages> Heard;
  vtkIdType Counted = 0;
};

/// The output of a new filter without a cache.
Grid Fresh(vtkDataObject* input, const Configure& configure = {});

bool SharesCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b);

inline bool SharesPoints(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  return a->GetPoints()->GetData() == b->GetPoints()->GetData();
}

Grid MakeInput(unsigned seed = 1);

inline void MovePoint(vtkUnstructuredGrid* grid, vtkIdType i, double x, double y, double z)
{
  grid->GetPoints()->SetPoint(i, x, y, z);
  grid->GetPoints()->Modified();
}

std::string Print(Filter* filter);

inline bool HoldsNothing(Filter* filter)
{
  return Print(filter).find("Operators kept: 0 (0 bytes)") != std::string::npos;
}

inline bool HoldsOperators(Filter* filter, int n)
{
  return Print(filter).find("Operators kept: " + std::to_string(n) + " (") != std::string::npos;
}

}

#endif
