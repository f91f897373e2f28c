// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TurnedLimits.h
 * Control points whose limits have given normals, and lie at given places (Mathematics 8,
 * Interpolation).
 *
 * A normal n is two linear equations, n . t = 0 for both tangents t of the limit, whose control
 * points move along n in proportion to their weights in t: the least change that satisfies them. A
 * place moves its own control point, as in Interpolation.h. All of them are found together.
 */
#ifndef SubdivisionObjects_TurnedLimits_h
#define SubdivisionObjects_TurnedLimits_h

#include "Core/Operators/Interpolation.h"
#include "Core/Operators/SparseRows.h"

#include <vector>

namespace subdivision
{

/// What is wanted of the limits of points, three numbers each.
struct WantedLimits
{
  const double* Points;
  const double* Normals; ///< zero: any
  const double* Parts;   ///< InterpolationLimits::Parts
  double Extent;         ///< of the points, to which tolerances are relative
};

struct TurnedLimits
{
  bool HasConverged = true;
  vtkIdType NumberFlat = 0; ///< of points with a normal, but without tangents
  vtkIdType FirstFlat = -1;
};

/// Finds the shifts of the points, three numbers each. `rows`: of the limits, and of their two
/// tangents.
TurnedLimits FindTurnedLimits(const SparseRows<long long>* rows, const WantedLimits& wanted,
  const InterpolationLimits& limits, std::vector<double>& shifts);

}

#endif
