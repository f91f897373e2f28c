// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceChecks.h
 * Checks the size of the output, and whether the scheme supports the options.
 */
#ifndef SubdivisionObjects_SurfaceChecks_h
#define SubdivisionObjects_SurfaceChecks_h

#include "Private/Surface/SurfaceCells.h"
#include "Private/Surface/SurfaceSubdivision.h"

namespace subdivision
{

/// Reads the cells, and tells their warnings and warnings of unused options. `isLarge`: whether the
/// levels need ids of 64 bits. Returns false after an error (passed to Fail): the output would be
/// too large.
bool ReadAndCheck(vtkPolyData* input, const SurfaceScheme<int>& scheme,
  const SurfaceOptions& options, SurfaceCells& cells, bool& isLarge);

/// Warns of options that the scheme ignores.
void WarnOfUnused(const SurfaceScheme<int>& scheme, const SurfaceOptions& options);

}

#endif
