// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidOrientation.h
 * Which tetrahedra have a negative volume: in a control mesh, and after smoothing, which may turn
 * them inside out.
 */
#ifndef SubdivisionObjects_SolidOrientation_h
#define SubdivisionObjects_SolidOrientation_h

#include "Core/Memory/Coordinates.h"
#include "Core/Memory/SimplexList.h"

#include <vector>

class vtkUnstructuredGrid;

namespace subdivision
{

/// Finds the tetrahedra that are inverted or flat. The result has 2i for each simplex i of negative
/// volume, and 2i + 1 for each one whose volume is zero but for rounding; it is ascending.
std::vector<vtkIdType> FindInvertedTets(const SimplexList& simplices, const Coordinates& points);

/// The known signs of the tetrahedra of an output before they are looked at.
struct KnownSigns
{
  /// For each cell `Steps` steps before: the sign that the volumes of all its descendants have, or
  /// 0. Empty: nothing is known.
  std::vector<signed char> Signs;
  int Steps = 0;
};

struct InvertedCells
{
  vtkIdType Count = 0;
  vtkIdType First = -1; ///< a cell of the output; -1: there is none
};

/// Finds the tetrahedra of an output, `levels` steps after a control mesh, whose volume has another
/// sign than their control tetrahedron; children of flat ones are left out. `inverted` is the
/// result of FindInvertedTets, `tie` of Coordinates. `signs`: from the writer of the cells, so that
/// most need no look. `marks`: one for each cell of the output, set to 1 for cells that were found;
/// may be null.
InvertedCells FindInvertedCells(const SimplexList& control, int levels,
  const std::vector<vtkIdType>& inverted, double tie, vtkUnstructuredGrid* output,
  const KnownSigns& signs, unsigned char* marks);

}

#endif
