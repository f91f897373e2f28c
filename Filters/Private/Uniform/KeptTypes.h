// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KeptTypes.h
 * Uniform linear refinement that keeps the types of cells (KeepCellTypes).
 */
#ifndef SubdivisionObjects_KeptTypes_h
#define SubdivisionObjects_KeptTypes_h

#include "Private/Uniform/UniformSubdivision.h"

namespace subdivision
{

/// Returns false after an error (passed to Fail) or if Progress asks to stop.
bool RefineKeepingTypes(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output);

}

#endif
