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

/// The cells of a mesh that have one of the dimensions, and points which exist. `found` gets the
/// dimensions of all cells.
std::vector<vtkIdType> FindCells(vtkPointSet* mesh, int dimensions, WrongCells& wrong, int& found)
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
      const int bit = cell && type != VTK_EMPTY_CELL ? 1 << cell->GetCellDimension() : 0;
      isWanted[type] = (dimensions & bit) != 0;
      found |= bit;
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

std::string DescribeOthers(int found)
{
  std::string others;
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    const char* const names[4] = { "vertices", "lines", "surfaces", "solids" };
    others +=
      (found >> dimension & 1) ? (others.empty() ? "" : ", ") + std::string(names[dimension]) : "";
  }
  return "No cell has one of the dimensions that OutputDimensions asks for, so the output is "
         "empty. There are " +
    others + ": choose from these.";
}

}

vtkSmartPointer<vtkDataObject> TakeDimensions(vtkDataObject* data, int dimensions, bool isWhole,
  const std::function<void(const std::string&)>& warn)
{
  if (dimensions == AllDimensions)
  {
    return data;
  }
  WrongCells wrong;
  int found = 0;
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
      TakeCells(mesh, FindCells(mesh, dimensions, wrong, found), {}, part);
      AddFieldData(mesh->GetFieldData(), false, part->GetFieldData());
      return part;
    });
  if (isWhole && found != 0 && (found & dimensions) == 0)
  {
    warn(DescribeOthers(found));
  }
  if (wrong.Count > 0)
  {
    warn(std::to_string(wrong.Count) +
      " cell(s) have points that do not exist, the first is cell " + std::to_string(wrong.First) +
      ": the filter leaves them out. Correct their point ids.");
  }
  return taken;
}

}
