// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkSurface.h
 * Surface subdivision as it is measured: a scheme, its mesh and its levels.
 */
#ifndef SubdivisionObjects_BenchmarkSurface_h
#define SubdivisionObjects_BenchmarkSurface_h

#include "vtkSurfaceSubdivision.h"

#include "vtkSmartPointer.h"

#include <string>

namespace benchmarks
{

/// Null if no scheme has that name.
vtkSmartPointer<vtkSurfaceSubdivision> MakeSurfaceFilter(const std::string& name);

}

#endif
