// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/UnusedPoints.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/CellReader.h"

#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace subdivision
{

vtkIdTypeArray* GetMergedPoints(vtkPointSet* mesh)
{
  const vtkIdType size = mesh ? mesh->GetNumberOfPoints() : 0;
  auto* array = size > 0
    ? vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray(MergedPointsName))
    : nullptr;
  const bool isOfPoints = array && array->GetNumberOfValues() == size &&
    array->GetValueRange(0)[0] >= 0 && array->GetValueRange(0)[1] < size;
  return isOfPoints ? array : nullptr;
}

std::vector<vtkIdType> FindUnusedPoints(vtkPointSet* mesh)
{
  const CellReader cells(mesh);
  std::vector<char> used(static_cast<size_t>(mesh->GetNumberOfPoints()), 0);
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    for (vtkIdType i = 0; i < cell.Size; ++i)
    {
      if (cell.Ids[i] >= 0 && cell.Ids[i] < static_cast<vtkIdType>(used.size()))
      {
        used[cell.Ids[i]] = 1;
      }
    }
  }
  std::vector<vtkIdType> unused;
  for (size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i])
    {
      unused.push_back(static_cast<vtkIdType>(i));
    }
  }
  return unused;
}

}
