// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoincidentPoints.h
 * Points at the same place, which many files and sources have where parts touch.
 */
#ifndef SubdivisionObjects_CoincidentPoints_h
#define SubdivisionObjects_CoincidentPoints_h

#include "vtkSmartPointer.h"

class vtkDataObject;

namespace subdivision
{

/**
 * The mesh, or the blocks of a composite data set (ReadableMesh.h), with cells that share points:
 * of points with equal coordinates all cells have the one with the smallest global id (its index,
 * where there are none). The others stay, unused, so that ids stay. Polyhedra that have two points
 * at one place keep their points. Returns the input where nothing changes.
 */
vtkSmartPointer<vtkDataObject> MergeCoincidentPoints(vtkDataObject* readable);

}

#endif
