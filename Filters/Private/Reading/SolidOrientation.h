// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidOrientation.h
 * Which tetrahedra have a negative volume: those of a control mesh, and those that smoothing turned
 * inside out.
 */
#ifndef SubdivisionObjects_SolidOrientation_h
#define SubdivisionObjects_SolidOrientation_h

#include "Core/Memory/Coordinates.h"
#include "Core/Memory/SimplexList.h"

#include <vector>

class vtkUnstructuredGrid;

namespace subdivision
{

/// Twice the number of each simplex that is a tetrahedron of negative volume, by more than may be
/// rounding, and one more of each that is flat; ascending.
std::vector<vtkIdType> FindInvertedTets(const SimplexList& simplices, const Coordinates& points);

struct InvertedCells
{
  vtkIdType Count = 0;
  vtkIdType First = -1; ///< a cell of the output; -1: there is none
};

/// The tetrahedra of an output, `levels` steps below a control mesh, the volume of which has
/// another sign than that of the control tetrahedron they come from, if this is not flat;
/// `inverted` as FindInvertedTets gives them, `tie` as in Coordinates. `marks`: one for each cell,
/// or null.
InvertedCells FindInvertedCells(const SimplexList& control, int levels,
  const std::vector<vtkIdType>& inverted, double tie, vtkUnstructuredGrid* output,
  unsigned char* marks);

}

#endif
