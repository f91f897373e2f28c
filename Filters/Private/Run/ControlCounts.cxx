// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/ControlCounts.h"
#include "Core/Memory/Loops.h"
#include "Private/Reading/CellChecks.h"

#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeDataSetRange.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The simplices of a cell of so many corners that is split.
double CountPieces(int type, int dimension, double corners)
{
  switch (type)
  {
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
      return 1.;
    case VTK_PYRAMID:
      return 2.;
    case VTK_WEDGE:
      return 3.;
    default:
      return dimension == 3 ? 6. : std::max(1., corners - dimension);
  }
}

/// The cells that a cell of so many corners is where it keeps its type, or else its pieces.
double CountUncut(int type, int dimension, double corners)
{
  return dimension == 3 || corners == 4. ? 1. : CountPieces(type, dimension, corners);
}

/// Adds so many cells of this type, each with so many corners.
void AddCells(int type, double corners, double cells, ControlCounts& counts)
{
  const int dimension = GetDimensionOfType(type);
  if (dimension >= 0)
  {
    counts.at(dimension) += cells * CountPieces(type, dimension, corners);
    counts[4] += dimension == 2 ? cells * corners : 0.;
  }
  if (dimension >= 2)
  {
    counts[dimension == 2     ? 6
        : type == VTK_PYRAMID ? 7
                              : 8] += cells * CountUncut(type, dimension, corners);
  }
  counts[5] += cells;
}

void AddCellsOf(vtkDataSet* set, ControlCounts& counts)
{
  const vtkIdType size = set->GetNumberOfCells();
  vtkNew<vtkIdList> ids;
  if (size > 0 && set->GetExtentType() == VTK_3D_EXTENT) // all cells are alike
  {
    set->GetCellPoints(0, ids);
    AddCells(set->GetCellType(0), static_cast<double>(ids->GetNumberOfIds()),
      static_cast<double>(size), counts);
    return;
  }
  ForEachInTurn(size,
    [&](vtkIdType c)
    {
      set->GetCellPoints(c, ids);
      AddCells(set->GetCellType(c), static_cast<double>(ids->GetNumberOfIds()), 1., counts);
    });
}

}

ControlCounts CountControlCells(vtkDataObject* data)
{
  ControlCounts counts{};
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    AddCellsOf(set, counts);
  }
  else if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    for (vtkDataObject* block : vtk::Range(blocks))
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(block))
      {
        AddCellsOf(leaf, counts);
      }
    }
  }
  return counts;
}

}
