// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceBounds.h
 * GenerateErrorBounds of vtkSurfaceSubdivision.
 */
#ifndef SubdivisionObjects_SurfaceBounds_h
#define SubdivisionObjects_SurfaceBounds_h

#include "Private/Surface/SurfaceSubdivision.h"

namespace subdivision
{

/// Adds error bounds to the output of SubdivideSurface (ErrorBounds.h), or warns that there are
/// none. Returns false after an error, or a stop.
bool AddSurfaceBounds(vtkPolyData* input, const SurfaceOptions& options, vtkPolyData* output);

}

#endif
