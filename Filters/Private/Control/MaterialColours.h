// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MaterialColours.h
 * Colours of materials, so that those which meet in a point have different ones.
 */
#ifndef SubdivisionObjects_MaterialColours_h
#define SubdivisionObjects_MaterialColours_h

#include "Core/Memory/Buffer.h"
#include "Private/Arrays/Colours.h"
#include "Private/Reading/CellsToSimplices.h"

#include <algorithm>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace subdivision
{

/// The simplices of a mesh, and the colour of the material of each: materials that meet in a point
/// have different ones, and those of cells that are faces of others have NoColour.
struct ColouredSimplices
{
  /// `places`: the point that each point of the mesh is one with; empty: none is. `materials` are
  /// those of cells.
  ColouredSimplices(
    vtkPointSet* mesh, vtkDataArray* materials, const std::vector<vtkIdType>& places);
  vtkIdType GetSize() const { return this->Cells.Simplices.GetNumberOfSimplices(); }
  int GetDimension(vtkIdType i) const { return this->Cells.Simplices.Dimensions[i]; }
  vtkIdType GetCell(vtkIdType i) const
  {
    return this->Cells.ParentCells.empty() ? i : this->Cells.ParentCells[i];
  }
  /// The points of a simplex, in the input.
  Row<vtkIdType> GetPoints(vtkIdType i) const
  {
    const vtkIdType* ids = this->Cells.Simplices.Connectivity.data();
    return { ids + this->Offsets[i], ids + this->Offsets[i + 1] };
  }
  /// The point that copies of a point of the input are one of; centres are points of their own.
  vtkIdType GetPlace(vtkIdType point) const
  {
    const auto size = static_cast<vtkIdType>(this->Places.size());
    return point < size ? this->Places[point] : point;
  }
  bool Has(vtkIdType i, vtkIdType place) const
  {
    const Row<vtkIdType> points = this->GetPoints(i);
    return std::any_of(
      points.begin(), points.end(), [&](vtkIdType p) { return this->GetPlace(p) == place; });
  }

  SimplicesOfCells Cells;
  const std::vector<vtkIdType>& Places;
  std::vector<vtkIdType> Offsets; ///< of the points of each simplex
  std::vector<int> Colours;       ///< of each simplex
  int NumberOfColours = 1;
};

/// The colours that the cells at each point of a mesh have (the cell array ColourName).
std::vector<ColourMask> FindColoursAtPoints(vtkPointSet* mesh);

}

#endif
