// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Impulse.h
 * The values from which subdivision makes the basis function of a point.
 */
#ifndef SubdivisionObjects_Impulse_h
#define SubdivisionObjects_Impulse_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataObject;

namespace subdivision
{

/**
 * The mesh, or the blocks of a composite data set (ReadableMesh.h), with the point array
 * `BasisFunction` (double): 1 at the point of this global id, or of this index in a single mesh
 * without global ids, 0 elsewhere. `found`: whether there is such a point.
 */
vtkSmartPointer<vtkDataObject> AddImpulse(vtkDataObject* readable, vtkIdType point, bool& found);

}

#endif
