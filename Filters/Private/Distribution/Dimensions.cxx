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

#include <algorithm>
#include <array>

namespace subdivision
{
namespace
{

/// Cells with points that do not exist, which no output has.
struct WrongCells
{
  vtkIdType Count = 0;
  vtkIdType First = 0;
};

/// The cells of a mesh that have one of the dimensions, and points which exist.
std::vector<vtkIdType> FindCells(vtkPointSet* mesh, int dimensions, WrongCells& wrong)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  std::vector<vtkIdType> scratch;
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
    const CellIds ids = isWanted[type] ? reader.GetCell(c, scratch) : CellIds();
    const bool isWrong = std::any_of(
      ids.Ids, ids.Ids + ids.Size, [points](vtkIdType id) { return id < 0 || id >= points; });
    if (isWrong)
    {
      wrong.First = wrong.Count++ == 0 ? c : wrong.First;
    }
    else if (isWanted[type])
    {
      cells.push_back(c);
    }
  }
  return cells;
}

}

vtkSmartPointer<vtkDataObject> TakeDimensions(
  vtkDataObject* data, int dimensions, const std::function<void(const std::string&)>& warn)
{
  if (dimensions == AllDimensions)
  {
    return data;
  }
  WrongCells wrong;
  const auto taken = ChangeMeshes(data,
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
      TakeCells(mesh, FindCells(mesh, dimensions, wrong), {}, part);
      AddFieldData(mesh->GetFieldData(), false, part->GetFieldData());
      return part;
    });
  if (wrong.Count > 0)
  {
    warn(std::to_string(wrong.Count) +
      " cell(s) have points that do not exist, the first is cell " + std::to_string(wrong.First) +
      ": the filter leaves them out. Correct their point ids.");
  }
  return taken;
}

}
