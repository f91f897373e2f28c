// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellMeasures.h
 * Volumes of tetrahedra and hexahedra, and how thin they are.
 */
#ifndef SubdivisionObjects_CellMeasures_h
#define SubdivisionObjects_CellMeasures_h

#include "vtkType.h"

class vtkPointSet;

namespace subdivision
{

struct CellMeasures
{
  double Volume = 0.;
  /// Of the tetrahedron, or of the smallest tetrahedron that a corner of the hexahedron makes with
  /// its neighbours. In a cube each of these has a sixth of the volume.
  double Least = 0.;
};

/// `corners`: 4 of VTK_TETRA or 8 of VTK_HEXAHEDRON, whose faces are bilinear.
CellMeasures MeasureCell(vtkPointSet* mesh, const vtkIdType* corners, vtkIdType size);

}

#endif
