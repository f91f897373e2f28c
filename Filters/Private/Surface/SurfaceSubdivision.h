// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSubdivision.h
 * Does the work of vtkSurfaceSubdivision.
 */
#ifndef SubdivisionObjects_SurfaceSubdivision_h
#define SubdivisionObjects_SurfaceSubdivision_h

#include "Core/Operators/OperatorSequence.h"
#include "Private/Run/RunOptions.h"
#include "Private/Surface/SurfaceCache.h"

class vtkPolyData;

namespace subdivision
{

/// Places (LevelOptions) are for schemes that FindSurfacePlaces knows.
struct SurfaceOptions : LevelOptions
{
  SurfaceSchemeKind Scheme = SurfaceSchemeKind::Loop;
  bool JoinSeams = true;
  bool KeepsMerged = false; ///< seams of any values are joined, too
  bool SplitSharpEdges = false;
  /// A point array of the input, null where there is none: flatness s.
  vtkSmartPointer<vtkDataArray> Flatness;
};

/// Returns false after an error (passed to Fail) or if Progress asks to stop. The caller then
/// empties the output.
bool SubdivideSurface(vtkPolyData* input, const SurfaceOptions& options, vtkPolyData* output);

/// The operators of a surface without an output, for who applies them to other points.
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

/// How many layers of cells around its own a part of a mesh needs (Distribution.h). Cells of 4-8
/// lie in two control cells, and limits of their points reach one cell farther.
constexpr int CountLayersOfSurface(SurfaceSchemeKind scheme)
{
  return scheme == SurfaceSchemeKind::FourEight ? 3 : 2;
}

}

#endif
