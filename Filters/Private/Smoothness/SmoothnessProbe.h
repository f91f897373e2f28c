// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothnessProbe.h
 * Does the work of vtkSubdivisionSmoothness: examines a scheme at each simplex of a mesh, and
 * writes the results as cells with arrays, or one characteristic map.
 */
#ifndef SubdivisionObjects_SmoothnessProbe_h
#define SubdivisionObjects_SmoothnessProbe_h

#include "Core/Surfaces/Steps/SurfaceSchemes.h"
#include "Private/Run/RunOptions.h"

class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace subdivision
{

struct SmoothnessOptions : RunOptions
{
  bool SampleMaps = true;
  bool FailingOnly = false;
  vtkIdType MapOfCell = -1; ///< the cell whose characteristic map is the output; -1: none
  int MapLevels = 2;
  // Of solids:
  bool IsTetOct = false;
  // Of surfaces:
  SurfaceSchemeKind Scheme = SurfaceSchemeKind::Loop;
};

/// By the rules of vtkMultiDimensionalSubdivision. Returns false after an error (passed to Fail) or
/// if Progress asks to stop. The caller then empties the output.
bool ProbeSolids(vtkPointSet* input, const SmoothnessOptions& options, vtkUnstructuredGrid* output);

/// The same by the schemes of vtkSurfaceSubdivision.
bool ProbeSurfaces(
  vtkPolyData* input, const SmoothnessOptions& options, vtkUnstructuredGrid* output);

}

#endif
