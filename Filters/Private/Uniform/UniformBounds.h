// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformBounds.h
 * GenerateErrorBounds of vtkMultiDimensionalSubdivision.
 */
#ifndef SubdivisionObjects_UniformBounds_h
#define SubdivisionObjects_UniformBounds_h

#include "Private/Uniform/UniformSubdivision.h"

namespace subdivision
{

/// Adds error bounds to the output of SubdivideUniformly (ErrorBounds.h), or warns that there are
/// none. Returns false after an error, or a stop.
bool AddUniformBounds(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output);

}

#endif
