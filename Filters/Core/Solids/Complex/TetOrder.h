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
 * Re-orders the vertices of one tetrahedron, or of all, so that its marked edges become 02 and 13.
 * Marked is the pair of opposite edges whose midpoints are nearest to each other. The first vertex
 * stays first and the orientation stays, so that only one order is possible. Global ids break ties
 * (null: indices do); points beyond `numberOfGlobalIds` come after the others.
 */
void OrderTet(vtkIdType* tet, const Coordinates& points, const vtkIdType* globalIds,
  vtkIdType numberOfGlobalIds);
void OrderTets(SimplexList& simplices, const Coordinates& points, const vtkIdType* globalIds,
  vtkIdType numberOfGlobalIds);

}

#endif
