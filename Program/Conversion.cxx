// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion.h"
#include "Files.h"
#include "JoinedArrays.h"
#include "Messages.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
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

/// Filters of VTK crash at points that do not exist. Throws Failure.
void CheckPoints(vtkDataSet* set)
{
  std::vector<vtkCellArray*> all;
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(set))
  {
    all = { grid->GetCells() };
  }
  else if (auto* surface = vtkPolyData::SafeDownCast(set))
  {
    all = { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() };
  }
  for (vtkCellArray* cells : all)
  {
    double range[2] = { 0., -1. };
    if (cells && cells->GetNumberOfConnectivityIds() > 0)
    {
      cells->GetConnectivityArray()->GetRange(range);
    }
    if (range[0] < 0. || range[1] >= static_cast<double>(set->GetNumberOfPoints()))
    {
      throw Failure("the output has cells with points that do not exist, which this format cannot "
                    "hold; .vtu can. Correct the input in the program that wrote it.");
    }
  }
}

/// Throws Failure if there are cells that VTK writes into Exodus files wrongly, or not at all.
void CheckTypes(vtkUnstructuredGrid* grid)
{
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int type = grid->GetCellType(c);
    const bool isPlain = type >= VTK_VERTEX && type <= VTK_PYRAMID;
    const bool isQuadratic = type >= VTK_QUADRATIC_EDGE && type <= VTK_QUADRATIC_PYRAMID;
    if (type == VTK_PIXEL || type == VTK_VOXEL || !(isPlain || isQuadratic))
    {
      throw Failure("cell " + std::to_string(c) + " of the output is a " +
        grid->GetCell(c)->GetClassName() + ", which Exodus files cannot hold; .vtu files can");
    }
  }
}

Data SurfaceOf(vtkDataSet* set)
{
  CheckPoints(set);
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

Data AsGridOfNumbers(vtkDataObject* data)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->ShallowCopy(AsGrid(data));
  CheckPoints(grid);
  CheckTypes(grid);
  for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* arrays = grid->GetAttributes(association);
    for (int a = arrays->GetNumberOfArrays() - 1; a >= 0; --a)
    {
      if (!arrays->GetArray(a))
      {
        const char* name = arrays->GetAbstractArray(a)->GetName();
        Tell("warning",
          "the file holds numbers alone: the array \"" + std::string(name ? name : "") +
            "\" is left out; .vtu files keep it");
        arrays->RemoveArray(a);
      }
    }
  }
  return grid;
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
