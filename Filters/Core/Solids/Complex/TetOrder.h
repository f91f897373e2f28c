// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOrder.h
 * Which octahedron diagonal a tetrahedron of the input takes (Mathematics 2).
 */
#ifndef SubdivisionObjects_TetOrder_h
#define SubdivisionObjects_TetOrder_h

#include "Core/Memory/Coordinates.h"
#include "Core/Memory/SimplexList.h"

namespace subdivision
{

/**
 * Re-orders one tetrahedron, or all, so that its marked edges, those whose midpoints are nearest to
 * each other, are 02 and 13. The first vertex stays first, the orientation stays; that leaves one
 * order. `globalIds` breaks ties (null: the index does); points without one come after the others.
 */
void OrderTet(vtkIdType* tet, const Coordinates& points, const vtkIdType* globalIds,
  vtkIdType numberOfGlobalIds);
void OrderTets(SimplexList& simplices, const Coordinates& points, const vtkIdType* globalIds,
  vtkIdType numberOfGlobalIds);

}

#endif
