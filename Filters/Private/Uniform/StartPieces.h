// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StartPieces.h
 * The flat pieces at which searches for nearest places begin (SolidPieces.h), where the solids of
 * a level are tetrahedra and octahedra.
 *
 * An octahedron lies in several of the cells that a tetrahedron, or a quarter of an octahedron,
 * becomes by the rules of the box spline. But the points of a level are the same, so solids are cut
 * anew between them: then each piece is in one cell of the mesh, and its number says where.
 */
#ifndef SubdivisionObjects_StartPieces_h
#define SubdivisionObjects_StartPieces_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/SimplexList.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkUnstructuredGrid;

namespace subdivision
{

/// `fine`: `simplices` after one or two steps of the tet/oct scheme. `octahedra` says for each of
/// these of which octahedron it is a quarter; -1: of none.
vtkSmartPointer<vtkUnstructuredGrid> CutSolidsAnew(vtkUnstructuredGrid* fine,
  const SimplexList& simplices, const Buffer<vtkIdType>& octahedra, int steps);

}

#endif
