// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartsOfCells.h
 * The vertices, lines or faces that the cells of a surface's input became.
 */
#ifndef SubdivisionObjects_PartsOfCells_h
#define SubdivisionObjects_PartsOfCells_h

#include "Private/Surface/SurfaceCells.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace subdivision
{

/// Which of the vertices, lines or faces a cell has become, if it is one.
struct PartOfCell
{
  int Dimension = -1;
  int Count = 0;
  vtkIdType Part = -1;
  vtkIdType Cell = -1; ///< of the surface of the input
};

/// Of the cells of a vtkPolyData, or of the grid from which it was made.
class PartsOfCells
{
public:
  PartsOfCells(const SurfaceCells& cells, vtkPolyData* surface);

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Parts.size()); }
  const PartOfCell& operator[](vtkIdType cell) const { return this->Parts[cell]; }
  /// The cell of the input that a cell of the surface comes from.
  vtkIdType GetSource(vtkIdType cell) const;

private:
  vtkDataArray* Sources;
  std::vector<PartOfCell> Parts;
};

}

#endif
