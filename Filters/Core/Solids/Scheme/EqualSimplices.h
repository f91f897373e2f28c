// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EqualSimplices.h
 * The children of lines and triangles that equal earlier ones (EqualCells).
 */
#ifndef SubdivisionObjects_EqualSimplices_h
#define SubdivisionObjects_EqualSimplices_h

#include "Core/Solids/Complex/SimplicialComplex.h"

namespace subdivision
{

/// Makes the children of equal lines and triangles, and finds the twins of these children.
template <typename Id>
void RefineEqualLinesAndTriangles(
  const SimplicialComplex<Id>& parent, SimplicialComplex<Id>& child);

/// The edges of an EqualCells triangle in its own vertex order, taken from its twin.
template <typename Id>
void GetEdgesOfEqualTriangle(const SimplicialComplex<Id>& complex, vtkIdType index, Id edges[3]);

}

#endif
