// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceChecks.h
 * Checks the size of the output, and whether the scheme can do what options ask for.
 */
#ifndef SubdivisionObjects_SurfaceChecks_h
#define SubdivisionObjects_SurfaceChecks_h

#include "Private/Surface/SurfaceCells.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include <string>

namespace subdivision
{

/// An error message if the output would be too large; `faces`: about how many there will be.
std::string CheckSize(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceScheme<int>& scheme, const SurfaceOptions& options, double& faces);

/// Warns of options that the scheme ignores, and of polygons that it splits.
void WarnOfUnused(
  vtkPolyData* input, const SurfaceScheme<int>& scheme, const SurfaceOptions& options);

}

#endif
