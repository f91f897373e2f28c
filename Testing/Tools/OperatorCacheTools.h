// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OperatorCacheTools.h
 * A filter that is executed again and again, and what its outputs share.
 */
#ifndef SubdivisionObjects_OperatorCacheTools_h
#define SubdivisionObjects_OperatorCacheTools_h

#include "FeatureTools.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

#include <sstream>

namespace operator_cache_tools
{

using namespace feature_tools;

/// A filter that stays, and the messages it may not give.
class Kept
{
public:
  explicit Kept(const Configure& configure = {})
  {
    this->Heard->Watch(this->Cached);
    this->Cached->SetNumberOfLevels(2);
    if (configure)
    {
      configure(this->Cached);
    }
  }
  ~Kept()
  {
    EXPECT_TRUE(this->Heard->Errors.empty());
    EXPECT_TRUE(this->Heard->Warnings.empty());
  }
  Filter* operator->() { return this->Cached; }
  Filter* Get() { return this->Cached; }
  /// A copy of the output that shares its arrays.
  Grid Update(vtkDataObject* input)
  {
    this->Cached->SetInputDataObject(input);
    this->Cached->Modified();
    this->Cached->Update();
    const auto output = Grid::New();
    output->ShallowCopy(this->Cached->GetOutputDataObject(0));
    return output;
  }
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
inline Grid Fresh(vtkDataObject* input, const Configure& configure = {})
{
  return Execute(input, 2,
    [&](Filter* filter)
    {
      filter->CacheOperatorOff();
      if (configure)
      {
        configure(filter);
      }
    });
}

inline bool SharesCells(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  return a->GetCells()->GetConnectivityArray() == b->GetCells()->GetConnectivityArray() &&
    a->GetCells()->GetOffsetsArray() == b->GetCells()->GetOffsetsArray() &&
    subdivision::GetCellTypes(a) == subdivision::GetCellTypes(b);
}

inline bool SharesPoints(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  return a->GetPoints()->GetData() == b->GetPoints()->GetData();
}

inline Grid MakeInput(unsigned seed = 1)
{
  const Grid grid = MakeKuhnBox(2, 0.2, seed);
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("scalar", 1, grid->GetNumberOfPoints(), 0., 1., seed));
  return grid;
}

inline void MovePoint(vtkUnstructuredGrid* grid, vtkIdType i, double x, double y, double z)
{
  grid->GetPoints()->SetPoint(i, x, y, z);
  grid->GetPoints()->Modified();
}

inline std::string Print(Filter* filter)
{
  std::ostringstream text;
  filter->Print(text);
  return text.str();
}

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
