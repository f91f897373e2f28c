// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ErrorBounds.h
 * Adds certified bounds on the distance from the limit to an output.
 */
#ifndef SubdivisionObjects_ErrorBounds_h
#define SubdivisionObjects_ErrorBounds_h

#include "Core/Operators/MatrixFactors.h"
#include "Private/Run/RunOptions.h"

#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <functional>

class vtkPolyData;

namespace subdivision
{

/// Bounds on the distance from the limit, of cells, and how far it is away from points of the
/// input. Arrays of a point array have its name before.
constexpr const char* ErrorBoundName = "ErrorBound";
constexpr const char* SmoothingDistanceName = "SmoothingDistance";

/// A run of a filter, for bounds of its output.
struct BoundedRun
{
  vtkPointSet* Input = nullptr;
  vtkPointSet* Output = nullptr; ///< gets the arrays
  int Levels = 0;
  bool KnowsParts = false; ///< whether runs on parts of a mesh give the same as on the whole
  bool IsTetOct = false;   ///< whether solids follow the tet/oct scheme
  bool HasThirds = false;  ///< whether two steps cut edges into thirds, and not one into halves
  /// Of these, for each cell of the output the number of its octahedron; null: there is none.
  /// Makes another run: with so many levels, projected or not; the operators of its steps go to
  /// `factors`, unless that is null. Returns null after an error, or if it was stopped.
  std::function<vtkSmartPointer<vtkPointSet>(
    int levels, bool project, const RunOptions& options, MatrixFactors* factors)>
    Subdivide;
  /// The same by the plain rules at boundaries; null: the run follows them. Where both differ there
  /// is no proof.
  std::function<vtkSmartPointer<vtkPointSet>(
    int levels, const RunOptions& options, MatrixFactors* factors)>
    SubdividePlain;
  /// Makes steps on a patch of a mesh with thirds (PartsAsCells.h).
  std::function<vtkSmartPointer<vtkPointSet>(
    vtkPolyData* patch, int levels, const RunOptions& options, MatrixFactors* factors)>
    SubdividePatch;
};

/**
 * Adds the cell arrays ErrorBoundName and the point arrays SmoothingDistanceName of the points and
 * of all point arrays of floating point numbers. Needs a run of three more levels, or four. Warns,
 * and adds nothing, where there is no proof of a bound. If other partitions have parts of the mesh,
 * all call this together. Returns false after an error, or a stop.
 */
bool AddErrorBounds(const BoundedRun& run, const RunOptions& options);

}

#endif
