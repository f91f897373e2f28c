// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSurface.h
 * Does the work of vtkAdaptiveSurfaceSubdivision: refines an input in rounds of local splits.
 */
#ifndef SubdivisionObjects_AdaptiveSurface_h
#define SubdivisionObjects_AdaptiveSurface_h

#include "Private/Criteria/RefinementCriteria.h"
#include "Private/Surface/SurfaceSubdivision.h"

namespace subdivision
{

constexpr const char* GenerationName = "Generation";

/// The layers of control faces around its own that a partition needs (SharedFaces.h).
constexpr int LayersOfAdaptiveSurface = 3;

/// Returns false after an error (passed to Fail) or if Progress asks to stop. The caller then
/// empties the output.
bool RefineSurface(vtkPolyData* input, const SurfaceOptions& options,
  const RefinementOptions& criteria, vtkPolyData* output);

}

#endif
