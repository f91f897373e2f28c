// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedInterpolation.h
 * How a filter solves for control values of a mesh of which other partitions have parts, and warns
 * of the result.
 */
#ifndef SubdivisionObjects_SharedInterpolation_h
#define SubdivisionObjects_SharedInterpolation_h

#include "Core/Operators/Interpolation.h"
#include "Private/Run/RunOptions.h"

class vtkPointSet;

namespace subdivision
{

/// Whether all partitions say yes; without others, the answer of this one.
bool AgreeWithOthers(bool own, const RunOptions& options);

/// Lets the solver work together with the solvers of the other partitions, which all call this;
/// does nothing if there are none. `cells` were read from `input`, and have the control points.
void ConnectToOthers(vtkPointSet* input, const SimplicesOfCells& cells, const RunOptions& options,
  InterpolationLimits& limits);

/// Whether the weights of chosen points are from 0 to 1; an error names the first that is not.
bool HasWeights(
  const InterpolationOptions& options, const std::function<void(const std::string&)>& fail);

/// Warns if there is something to interpolate in the output of an earlier filter that did not do
/// so.
void WarnOfLateInterpolation(const InterpolationOptions& options,
  const std::vector<vtkIdType>& before, const std::function<void(const std::string&)>& warn);

/// Warns of values of the output beyond the range of the input's. All partitions call this. If
/// there are several, each looks at the cells that are made of its own, and nothing is counted.
/// `isLimit`: points are on the limit; warns also of values of materials that are not.
void TellOvershoot(
  const PointArrays& arrays, const RunOptions& options, vtkPointSet* output, bool isLimit);

}

#endif
