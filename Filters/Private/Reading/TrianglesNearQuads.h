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

namespace subdivision
{

/// The boundary of a PIXEL or QUAD in order.
void GetQuad(int cellType, const vtkIdType* ids, vtkIdType* quad);

/// Triangle `i` of a strip; every second one turns the other way round.
void GetStripTriangle(const vtkIdType* ids, vtkIdType i, vtkIdType* triangle);

/// Whether the quad consists of two edges that are there twice.
bool IsFolded(const vtkIdType* quad);

/**
 * The triangles of the mesh, cells as well as faces (also those of collapsed cells), that have
 * three points of quads. Where solids and shells meet these are few of many; all others cannot
 * touch a diagonal.
 */
std::vector<TriangleKey> FindTrianglesNearQuads(
  const CellReader& cells, const CheckedCells& checked, vtkIdType numberOfPoints);

}

#endif
