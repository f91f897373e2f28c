// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UnusedPoints.h
 * Finds points without cells.
 */
#ifndef SubdivisionObjects_UnusedPoints_h
#define SubdivisionObjects_UnusedPoints_h

#include "vtkType.h"

#include <vector>

class vtkPointSet;

namespace subdivision
{

/// The points that no cell of a mesh uses, ascending. Hidden cells count too.
std::vector<vtkIdType> FindUnusedPoints(vtkPointSet* mesh);

}

#endif
