// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MissingValues.h
 * Values of points that are missing: not a number, infinite, or hidden by a mask.
 */
#ifndef SubdivisionObjects_MissingValues_h
#define SubdivisionObjects_MissingValues_h

#include "Private/Run/RunOptions.h"

#include <functional>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace subdivision
{

/**
 * Calls work(mesh, output) for `input`. Where this has the point array vtkValidPointMask, floating
 * point arrays of `mesh` are not a number at points whose mask is 0, and the mask of the output is
 * 0 where the work took one of these. One warning counts the points where values are missing, in
 * the input and in the output, unless they are the same, and has the note of the work.
 */
bool RunWithMissingValues(vtkPointSet* input, vtkPointSet* output, RunOptions& options,
  const std::function<bool(vtkPointSet*, vtkPointSet*)>& work);

/// Notes that RefineByAttributeError leaves out these edges (pairs of points), because the array
/// has no value there; `where`: words after "is not finite".
void NoteEdgesWithoutValue(std::vector<std::pair<vtkIdType, vtkIdType>>& edges, vtkDataArray* array,
  const char* where, const RunOptions& options);

}

#endif
