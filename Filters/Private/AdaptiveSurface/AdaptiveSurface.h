// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSurface.h
 * From input to output in rounds of local splits: what vtkSurfaceSubdivision does with Adaptive.
 */
#ifndef SubdivisionObjects_AdaptiveSurface_h
#define SubdivisionObjects_AdaptiveSurface_h

#include "Private/Criteria/RefinementCriteria.h"
#include "Private/Surface/SurfaceSubdivision.h"

namespace subdivision
{

constexpr const char* GenerationName = "Generation";

/// False: stopped by an error (told to Fail) or by Progress. The output is then to be emptied.
bool RefineSurface(vtkPolyData* input, const SurfaceOptions& options,
  const RefinementOptions& criteria, vtkPolyData* output);

}

#endif
