// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceOperators.h
 * The operators of a subdivision surface without an output, for who applies them to other points.
 */
#ifndef SubdivisionObjects_SurfaceOperators_h
#define SubdivisionObjects_SurfaceOperators_h

#include "Core/Operators/OperatorSequence.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include "vtkSmartPointer.h"

#include <memory>

class vtkDataArray;

namespace subdivision
{

struct SurfaceOperators
{
  std::unique_ptr<OperatorSequence> Steps; ///< null for no step
  vtkSmartPointer<vtkDataArray> Points;    ///< after the steps, in double
  /// After the steps, three corners each: faces as triangles (PolygonEars.h), then lines and
  /// vertices, whose last corners are repeated.
  Buffer<vtkIdType> Triangles;
};

/// Finds the operators, for a scheme that keeps vertices. Returns false after an error (passed to
/// Fail) or if Progress asks to stop.
bool FindSurfaceOperators(
  vtkPolyData* input, const SurfaceOptions& options, SurfaceOperators& operators);

}

#endif
