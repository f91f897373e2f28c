// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UnusedPoints.h
 * Points without cells: finds them, and warns of points that lost their cells.
 */
#ifndef SubdivisionObjects_UnusedPoints_h
#define SubdivisionObjects_UnusedPoints_h

#include "vtkType.h"

#include <vector>

class vtkIdTypeArray;
class vtkPointSet;

namespace subdivision
{

/// The point array that says, of points which MergeCoincidentPoints merged, the point that each
/// became; of all others themselves.
constexpr const char* MergedPointsName = "SubdivisionMergedPoints";

/// That array of a mesh; null if there is none, or one whose values are no points.
vtkIdTypeArray* GetMergedPoints(vtkPointSet* mesh);

/// The points that no cell of a mesh uses, ascending. Hidden cells count too.
std::vector<vtkIdType> FindUnusedPoints(vtkPointSet* mesh);

}

#endif
