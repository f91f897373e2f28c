// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion.h"
#include "JoinedArrays.h"
#include "Messages.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

namespace subdivide
{
namespace
{

using Data = vtkSmartPointer<vtkDataObject>;

Data Filtered(vtkAlgorithm* filter, vtkDataObject* data)
{
  filter->SetInputDataObject(data);
  filter->Update();
  return filter->GetOutputDataObject(0);
}

/// One mesh of all data sets, by a filter that appends and keeps only what all of them have.
template <typename Append>
Data Joined(const std::vector<vtkSmartPointer<vtkDataSet>>& sets)
{
  const JoinedArrays arrays(sets);
  vtkNew<Append> append;
  for (const auto& set : sets)
  {
    append->AddInputDataObject(arrays.Complete(set));
  }
  append->Update();
  auto* joined = vtkDataSet::SafeDownCast(append->GetOutputDataObject(0));
  arrays.Finish(joined);
  return joined;
}

Data SurfaceOf(vtkDataSet* set)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  return vtkPolyData::SafeDownCast(set) ? set : Filtered(surface, set);
}

}

std::vector<vtkDataSet*> GetDataSets(vtkDataObject* data)
{
  std::vector<vtkDataSet*> sets;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      const auto more = GetDataSets(iterator->GetCurrentDataObject());
      sets.insert(sets.end(), more.begin(), more.end());
    }
  }
  else if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    sets.push_back(set);
  }
  return sets;
}

Data AsGrid(vtkDataObject* data)
{
  if (vtkUnstructuredGrid::SafeDownCast(data))
  {
    return data;
  }
  std::vector<vtkSmartPointer<vtkDataSet>> sets;
  for (vtkDataSet* set : GetDataSets(data))
  {
    sets.emplace_back(set);
  }
  return Joined<vtkAppendFilter>(sets);
}

Data AsSurface(vtkDataObject* data)
{
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    return SurfaceOf(set);
  }
  std::vector<vtkSmartPointer<vtkDataSet>> sets;
  for (vtkDataSet* set : GetDataSets(data))
  {
    sets.emplace_back(vtkDataSet::SafeDownCast(SurfaceOf(set)));
  }
  return Joined<vtkAppendPolyData>(sets);
}

Data AsTriangles(vtkDataObject* data)
{
  const Data whole = AsSurface(data);
  auto* surface = vtkPolyData::SafeDownCast(whole);
  const vtkIdType lost = surface->GetNumberOfLines() + surface->GetNumberOfVerts();
  if (lost > 0 && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
  {
    Tell("warning",
      "the file holds surfaces alone: " + std::to_string(lost) +
        " lines and vertices are left out; .vtp and .vtu files keep them");
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  return Filtered(triangles, whole);
}

Data AsBlocks(vtkDataObject* data)
{
  if (vtkMultiBlockDataSet::SafeDownCast(data))
  {
    return data;
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, data);
  return blocks;
}

Data AsItIs(vtkDataObject* data)
{
  return data;
}

}
