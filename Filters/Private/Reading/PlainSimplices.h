// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainSimplices.h
 * Reads the most common input fast: one in which all cells are simplices and none has a fault.
 */
#ifndef SubdivisionObjects_PlainSimplices_h
#define SubdivisionObjects_PlainSimplices_h

#include "Private/Reading/CellReader.h"

#include <vector>

namespace subdivision
{

/// Whether all values are finite; false also for arrays of a layout or type that this test cannot
/// read.
bool AreFinite(vtkDataArray* array);

/// Finds the dimension of each cell. Returns false, and no dimensions, if a cell is hidden, has a
/// fault or is not a simplex, or if a coordinate is not finite; CheckCells then finds out which.
bool ReadPlainSimplices(
  vtkPointSet* input, const CellReader& cells, std::vector<unsigned char>& dimensions);

}

#endif
