// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceChecks.h
 * What is asked of a surface and its options before anything is made.
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

/// Says what an option asks for and the scheme does not have.
void WarnOfUnused(
  vtkPolyData* input, const SurfaceScheme<int>& scheme, const SurfaceOptions& options);

}

#endif
