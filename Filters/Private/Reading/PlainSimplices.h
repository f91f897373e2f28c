// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlainSimplices.h
 * The usual input, read at the speed of memory: cells that are simplices all, none with a fault.
 */
#ifndef SubdivisionObjects_PlainSimplices_h
#define SubdivisionObjects_PlainSimplices_h

#include "Private/Reading/CellReader.h"

#include <vector>

namespace subdivision
{

/// Finds the dimension of each cell. False, and none, where some cell is hidden, has a fault or is
/// not a simplex, or where some coordinate is not finite: CheckCells tells what is the matter.
bool ReadPlainSimplices(
  vtkPointSet* input, const CellReader& cells, std::vector<unsigned char>& dimensions);

}

#endif
