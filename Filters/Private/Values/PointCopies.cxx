// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Values/PointCopies.h"

#include "Private/ArrayNames.h"

#include <algorithm>

namespace subdivision
{

Buffer<vtkIdType> FindJoinedPoints(vtkPointSet* torn, vtkPointSet* joined)
{
  const CellReader cells(torn);
  const CellReader others(joined);
  Buffer<vtkIdType> found(torn->GetNumberOfPoints(), -1);
  std::vector<vtkIdType> scratch[2];
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch[0]);
    const CellIds other = others.GetCell(c, scratch[1]);
    for (vtkIdType i = 0; i < std::min(cell.Size, other.Size); ++i)
    {
      const vtkIdType id = cell.Ids[i];
      id >= 0 && id < found.size() ? void(found[id] = other.Ids[i]) : void();
    }
  }
  return found;
}

vtkSmartPointer<vtkDataArray> CopyOfValues(vtkDataArray* array)
{
  const auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  if (!array->HasStandardMemoryLayout())
  {
    copy->DeepCopy(array);
    return copy;
  }
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->SetNumberOfTuples(array->GetNumberOfTuples());
  CopyInThreads(static_cast<const char*>(array->GetVoidPointer(0)),
    array->GetNumberOfValues() * array->GetDataTypeSize(),
    static_cast<char*>(copy->GetVoidPointer(0)));
  return copy;
}

std::vector<vtkIdType> FindFirstCopies(vtkPointSet* mesh)
{
  const vtkIdType size = mesh->GetNumberOfPoints();
  std::vector<vtkIdType> firsts;
  if (!HasIds(mesh->GetPointData(), MaterialPointIdsName, size))
  {
    return firsts;
  }
  vtkDataArray* ids = mesh->GetPointData()->GetArray(MaterialPointIdsName);
  std::unordered_multimap<vtkIdType, vtkIdType> places; // appended meshes have the same ids
  bool hasCopies = false;
  for (const vtkIdType i : InTurn(size))
  {
    const vtkIdType id = ToId(ids->GetComponent(i, 0));
    double ours[3];
    mesh->GetPoint(i, ours);
    const auto same = places.equal_range(id);
    const auto first = std::find_if(same.first, same.second,
      [&](const auto& place)
      {
        double theirs[3];
        mesh->GetPoint(place.second, theirs);
        return std::equal(ours, ours + 3, theirs);
      });
    const bool isCopy = id >= 0 && first != same.second;
    firsts.push_back(isCopy ? first->second : i);
    hasCopies = hasCopies || isCopy;
    if (id >= 0 && !isCopy)
    {
      places.emplace(id, i);
    }
  }
  if (!hasCopies)
  {
    firsts.clear();
  }
  return firsts;
}

void SetCellArrays(vtkPointSet* mesh, vtkUnsignedCharArray* types,
  const std::vector<vtkSmartPointer<vtkCellArray>>& cells)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
  {
    grid->SetCells(types, cells[0]);
    return;
  }
  auto* surface = vtkPolyData::SafeDownCast(mesh);
  surface->SetVerts(cells[0]);
  surface->SetLines(cells[1]);
  surface->SetPolys(cells[2]);
  surface->SetStrips(cells[3]);
}

}
