// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MaterialColours.h
 * Colours of materials: materials that have points of one simplex have different ones.
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

class OtherPartitions;

/// The simplices of a mesh, and the colour of the material of each: materials that have points of
/// one simplex have different ones, and cells that are faces of others have NoColour.
struct ColouredSimplices
{
  /// `materials` are the materials of cells. `others`: the other partitions of the mesh, which call
  /// this too, and in which materials have the same colours; null: there are none.
  ColouredSimplices(vtkPointSet* mesh, vtkDataArray* materials, OtherPartitions* others);
  vtkIdType GetSize() const { return this->Cells.Simplices.GetNumberOfSimplices(); }
  int GetDimension(vtkIdType i) const { return this->Cells.Simplices.Dimensions[i]; }
  vtkIdType GetCell(vtkIdType i) const
  {
    return this->Cells.ParentCells.empty() ? i : this->Cells.ParentCells[i];
  }
  /// The points of a simplex; points that the mesh does not have are centres of cells.
  Row<vtkIdType> GetPoints(vtkIdType i) const
  {
    const vtkIdType* ids = this->Cells.Simplices.Connectivity.data();
    return { ids + this->Offsets[i], ids + this->Offsets[i + 1] };
  }
  bool Has(vtkIdType i, vtkIdType point) const
  {
    const Row<vtkIdType> points = this->GetPoints(i);
    return std::find(points.begin(), points.end(), point) != points.end();
  }

  SimplicesOfCells Cells;
  std::vector<vtkIdType> Offsets; ///< of the points of each simplex
  std::vector<int> Colours;       ///< of each simplex
  int NumberOfColours = 1;
  /// The number of the material of each simplex among all materials of all partitions; -1: no
  /// colour.
  std::vector<int> Materials;
  int NumberOfMaterials = 1;
};

/// The colours that the cells at each point of a mesh have (the cell array ColourName).
std::vector<ColourMask> FindColoursAtPoints(vtkPointSet* mesh);

}

#endif
