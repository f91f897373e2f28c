// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridColours.h
 * The colours of materials (MaterialFields.h) at the points of cells that keep their types.
 */
#ifndef SubdivisionObjects_HybridColours_h
#define SubdivisionObjects_HybridColours_h

#include "Core/Cells/CellComplex.h"
#include "Private/Arrays/PointArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointSet.h"

#include <vector>

namespace subdivision
{

/// The colour of each cell; empty if no array has weights. `sources`: the cell of the input of
/// each.
inline std::vector<int> ReadColours(
  vtkPointSet* input, const std::vector<vtkIdType>& sources, const PointArrays& points)
{
  std::vector<int> values;
  if (points.HasWeights())
  {
    vtkDataArray* colours = input->GetCellData()->GetArray(ColourName);
    for (const vtkIdType cell : InTurn(sources))
    {
      values.push_back(static_cast<int>(colours->GetComponent(cell, 0)));
    }
  }
  return values;
}

/// Takes away values of materials that no cell at a point has.
template <typename Id>
void KeepColours(vtkPointSet* input, const CellList<Id>& cells,
  const std::vector<vtkIdType>& sources, PointArrays& points)
{
  const std::vector<int> colours = ReadColours(input, sources, points);
  if (!points.HasWeights())
  {
    return;
  }
  ColourMasks masks(cells.NumberOfPoints);
  masks.Add(
    cells.GetNumberOfCells(), [&](vtkIdType c) { return cells.Offsets[c]; },
    [&](vtkIdType i) { return cells.Corners[i]; },
    [&](vtkIdType c) { return colours[static_cast<std::size_t>(c)]; });
  points.KeepColours(masks.Get());
}

}

#endif
