// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceInput.h
 * Makes the vtkPolyData that the surface filters read out of a vtkUnstructuredGrid.
 */
#ifndef SubdivisionObjects_SurfaceInput_h
#define SubdivisionObjects_SurfaceInput_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace subdivision
{

/**
 * The cells of a grid: first the vertices, then lines, then polygons, then strips. Of solids it has
 * the outside, after all polygons: the faces that no other solid and no polygon has. A warning
 * counts them. Without `takesOutside` solids are left out. Non-linear cells are cut
 * (NonLinearCells.h). Cells that cannot be used are left out with a warning, hidden ones without.
 * Points and their arrays are shared, cell data follow their cells. With `originalIds` the cell
 * array SourceCellsName has the cells of the grid.
 */
vtkSmartPointer<vtkPolyData> MakeSurface(vtkUnstructuredGrid* grid, bool takesOutside,
  bool originalIds, std::vector<std::string>& warnings);

/// The first cell of a grid that is a usable solid; -1: it has none.
vtkIdType FindFirstSolid(vtkUnstructuredGrid* grid);

/// The original ids of the cells of an output, or of its blocks, become ids of the grid where
/// MakeSurface made the input.
void RestoreSourceCells(vtkDataObject* output);

}

#endif
