// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TrianglesNearQuads.h
 * The triangles that may fix the diagonal of a quad.
 */
#ifndef SubdivisionObjects_TrianglesNearQuads_h
#define SubdivisionObjects_TrianglesNearQuads_h

#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/QuadDiagonals.h"

#include "vtkType.h"

#include <vector>

class vtkPointSet;

namespace subdivision
{

/// The boundary of a PIXEL or QUAD in order.
void GetQuad(int cellType, const vtkIdType* ids, vtkIdType* quad);

/// Triangle `i` of a strip. Two points of every second one are exchanged, so that all triangles are
/// oriented alike.
void GetStripTriangle(const vtkIdType* ids, vtkIdType i, vtkIdType* triangle);

/// Whether two opposite points of the quad are equal. It has no area then: its boundary runs along
/// two edges, twice along each.
bool IsFolded(const vtkIdType* quad);

/**
 * The triangles of the mesh (cells and faces of cells, also of collapsed ones) whose three points
 * are points of quads. No other triangle can lie on a diagonal, and these are usually few.
 */
std::vector<TriangleKey> FindTrianglesNearQuads(
  vtkPointSet* input, const CellReader& cells, const CheckedCells& checked);

}

#endif
