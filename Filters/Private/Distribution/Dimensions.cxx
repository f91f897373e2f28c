// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Dimensions.h"

#include "Core/Memory/Loops.h"
#include "Private/Distribution/Blocks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/ReadableMesh.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <array>

namespace subdivision
{
namespace
{

/// The cells of a mesh that have one of the dimensions.
std::vector<vtkIdType> FindCells(vtkPointSet* mesh, int dimensions)
{
  constexpr signed char unknown = -1;
  std::array<signed char, 256> isWanted;
  isWanted.fill(unknown);
  const CellReader reader(mesh);
  std::vector<vtkIdType> cells;
  for (const vtkIdType c : InTurn(reader.GetNumberOfCells()))
  {
    const int type = reader.GetCellType(c);
    if (isWanted[type] == unknown)
    {
      const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      isWanted[type] =
        cell && type != VTK_EMPTY_CELL && (dimensions >> cell->GetCellDimension() & 1);
    }
    if (isWanted[type])
    {
      cells.push_back(c);
    }
  }
  return cells;
}

}

vtkSmartPointer<vtkDataObject> TakeDimensions(vtkDataObject* data, int dimensions)
{
  if (dimensions == AllDimensions)
  {
    return data;
  }
  return ChangeMeshes(data,
    [&](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* mesh = vtkPointSet::SafeDownCast(object);
      const bool isMesh =
        vtkUnstructuredGrid::SafeDownCast(object) || vtkPolyData::SafeDownCast(object);
      if (!isMesh || !mesh->GetPoints())
      {
        return object;
      }
      auto part = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
      TakeCells(mesh, FindCells(mesh, dimensions), {}, part);
      AddFieldData(mesh->GetFieldData(), false, part->GetFieldData());
      return part;
    });
}

}
