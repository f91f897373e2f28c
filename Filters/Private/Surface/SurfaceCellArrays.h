// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceCellArrays.h
 * Copies cell data of surfaces from cells to their children.
 */
#ifndef SubdivisionObjects_SurfaceCellArrays_h
#define SubdivisionObjects_SurfaceCellArrays_h

#include "Core/Surfaces/Steps/SurfaceSteps.h"
#include "Private/Run/RunOptions.h"
#include "Private/Surface/SurfaceCells.h"
#include "Private/Surface/SurfaceStamp.h"

namespace subdivision
{

/// Copies every cell array of `input`, whose cells are level `firstStep`, to the cells of the last
/// level. The sharpness of lines is reduced.
/// `goesOn`: an earlier filter made the input, so that its original ids are kept. `carried`: before
/// the call the data that this filter left, afterwards the data for the next one.
template <typename Id>
void CopySurfaceCellArrays(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceSteps<Id>& steps, int firstStep, bool goesOn, const RunOptions& options,
  CarriedCells& carried, vtkPolyData* output);

}

#endif
