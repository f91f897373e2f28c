// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointCopies.h
 * Points of which a mesh has several copies (the point array MaterialPointIds), and meshes whose
 * points are replaced by others of them, or by copies.
 */
#ifndef SubdivisionObjects_PointCopies_h
#define SubdivisionObjects_PointCopies_h

#include "Core/Memory/Buffer.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellReader.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <vector>

namespace subdivision
{

/// For each point the first one with the same MaterialPointIds and the same coordinates; points
/// with a negative id are alone. Empty if all are different.
std::vector<vtkIdType> FindFirstCopies(vtkPointSet* mesh);

/// For each point of a mesh whose sides are torn the one of the joined mesh with the same cells; -1
/// for points without cells.
Buffer<vtkIdType> FindJoinedPoints(vtkPointSet* torn, vtkPointSet* joined);

/// A copy of the values of an array, made in parts: DeepCopy of VTK cannot be stopped.
vtkSmartPointer<vtkDataArray> CopyOfValues(vtkDataArray* array);

/// A copy of cells, the first of which is cell `first` of its mesh. change(cell, begin, end) may
/// change the ids of its points, which are below `size`.
template <typename Change>
vtkSmartPointer<vtkCellArray> CopyCells(
  vtkCellArray* cells, vtkIdType first, vtkIdType size, const Change& change)
{
  const auto copy = vtkSmartPointer<vtkCellArray>::New();
  copy->SetData(
    CopyOfValues(cells->GetOffsetsArray()), CopyOfValues(cells->GetConnectivityArray()));
  if (!copy->IsStorage64Bit() && size > std::numeric_limits<vtkTypeInt32>::max())
  {
    copy->ConvertTo64BitStorage();
  }
  CellReader::Integers offsets;
  offsets.Set(copy->GetOffsetsArray());
  auto changeAll = [&](auto* ids)
  {
    ForEach(cells->GetNumberOfCells(),
      [&](vtkIdType c) { change(first + c, ids + offsets[c], ids + offsets[c + 1]); });
  };
  void* ids = copy->GetConnectivityArray()->GetVoidPointer(0);
  copy->IsStorage64Bit() ? changeAll(static_cast<vtkTypeInt64*>(ids))
                         : changeAll(static_cast<vtkTypeInt32*>(ids));
  return copy;
}

/// Calls visit(cells, id of the first) for each vtkCellArray of a mesh.
template <typename Visit>
void ForEachCellArray(vtkPointSet* mesh, const Visit& visit)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    visit(grid->GetCells(), 0);
    return;
  }
  auto* surface = vtkPolyData::SafeDownCast(mesh);
  vtkIdType first = 0;
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    visit(cells, first);
    first += cells->GetNumberOfCells();
  }
}

/// Gives a mesh the cells of such arrays; `types`: the types of a grid.
void SetCellArrays(vtkPointSet* mesh, vtkUnsignedCharArray* types,
  const std::vector<vtkSmartPointer<vtkCellArray>>& cells);

/// Gives a mesh such copies of its cells.
template <typename Change>
void ChangeCells(vtkPointSet* mesh, vtkIdType size, const Change& change)
{
  std::vector<vtkSmartPointer<vtkCellArray>> made;
  ForEachCellArray(mesh, [&](vtkCellArray* cells, vtkIdType first)
    { made.push_back(CopyCells(cells, first, size, change)); });
  auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
  SetCellArrays(mesh, grid ? GetCellTypes(grid) : nullptr, made);
}

/// Replaces points and point data by the ones of `sources`, and ids by the result of `change`.
template <typename Change>
void TakePoints(vtkPointSet* mesh, const std::vector<vtkIdType>& sources, const Change& change)
{
  const Row<vtkIdType> row{ sources.data(), sources.data() + sources.size() };
  const auto from = vtkSmartPointer<vtkPointData>::New();
  from->ShallowCopy(mesh->GetPointData());
  mesh->GetPointData()->Initialize();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    AddLike(from, a, Gather(from->GetAbstractArray(a), row), mesh->GetPointData());
  }
  const auto coordinates = Gather(mesh->GetPoints()->GetData(), row);
  vtkNew<vtkPoints> points;
  points->SetDataType(coordinates->GetDataType());
  points->SetData(vtkDataArray::SafeDownCast(coordinates));
  mesh->SetPoints(points);
  ChangeCells(mesh, static_cast<vtkIdType>(sources.size()), change);
}

}

#endif
