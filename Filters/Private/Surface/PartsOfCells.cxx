// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/PartsOfCells.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace subdivision
{

PartsOfCells::PartsOfCells(const SurfaceCells& cells, vtkPolyData* surface)
  : Sources(surface->GetCellData()->GetArray(SourceCellsName))
{
  vtkIdType size = 0;
  for (const vtkIdType cell : InTurn(surface->GetNumberOfCells()))
  {
    size = std::max(size, this->GetSource(cell) + 1);
  }
  this->Parts.resize(static_cast<std::size_t>(size));
  const auto add = [&](const std::vector<vtkIdType>& owners, int dimension)
  {
    for (const std::size_t i : InTurn(owners.size()))
    {
      PartOfCell& part = this->Parts[this->GetSource(owners[i])];
      part = { dimension, part.Count + 1, static_cast<vtkIdType>(i), owners[i] };
    }
  };
  add(cells.VertexCells, 0);
  add(cells.SegmentCells, 1);
  add(cells.FaceCells, 2);
}

vtkIdType PartsOfCells::GetSource(vtkIdType cell) const
{
  return this->Sources ? static_cast<vtkIdType>(this->Sources->GetComponent(cell, 0)) : cell;
}

}
