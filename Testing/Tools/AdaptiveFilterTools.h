// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveFilterTools.h
 * Runs of vtkAdaptiveSurfaceSubdivision.
 */
#ifndef SubdivisionObjects_AdaptiveFilterTools_h
#define SubdivisionObjects_AdaptiveFilterTools_h

#include "MultiDimensionalSubdivisionTools.h"
#include "SurfaceTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"

namespace adaptive_filter_tools
{

using namespace surfacetools;

using Filter = vtkAdaptiveSurfaceSubdivision;
using PolyData = vtkSmartPointer<vtkPolyData>;
using multi_dimensional_subdivision_tools::Messages;

/// A filter that refines by nothing, as `configure` changes it.
PolyData Refine(
  vtkPolyData* input, const std::function<void(Filter*)>& configure, Messages* messages = nullptr);

void WantLevel(vtkPolyData* input, int level);

/// A round hill on a grid, with arrays of all kinds.
PolyData MakeHill(int size);

double GetLargestDistance(vtkPolyData* from, vtkPolyData* to);

/// By how far it is from the limit.
PolyData RefineByShape(vtkPolyData* input, double tolerance);

}

#endif
