// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapsedCells.h
 * Solids with repeated points, as the cells that they are: mesh generators write wedges, pyramids
 * and tetrahedra as hexahedra with collapsed edges and sides.
 */
#ifndef SubdivisionObjects_CollapsedCells_h
#define SubdivisionObjects_CollapsedCells_h

#include "vtkType.h"

#include <vector>

namespace subdivision
{

struct CollapsedCell
{
  /// VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, or FaceLoops (PolyhedronFaces.h) of another closed cell;
  /// VTK_EMPTY_CELL: nothing is left that is closed.
  int Type = 0;
  std::vector<vtkIdType> Points; ///< as a cell of this type has them
};

/// The cell that remains of a cell with a face table (SolidCells.h) when equal neighbours are
/// dropped from each side, sides of fewer than three points vanish, and equal sides that look at
/// each other vanish together.
CollapsedCell CollapseSolid(int cellType, const vtkIdType* ids);

}

#endif
