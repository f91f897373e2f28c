// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Interpolation.h
 * Control values whose limits are given values: the solution of L c = d, where L has a limit row
 * for each control vertex (Mathematics 8, Interpolation).
 *
 * The solver is Chebyshev iteration. It multiplies by L and knows two bounds of its eigenvalues. It
 * needs no inner products, so that the bits of the result depend neither on the number of threads
 * nor on what else is solved for. Rows of L are means, so that no eigenvalue exceeds 1. The lower
 * bound is a guess: with smaller eigenvalues, as long as they are positive, the iteration converges
 * more slowly.
 */
#ifndef SubdivisionObjects_Interpolation_h
#define SubdivisionObjects_Interpolation_h

#include "Core/Operators/PointOperator.h"
#include "Core/Rules/LoopWeights.h"

#include <functional>
#include <vector>

namespace subdivision
{

/// What the solver expects of the limits of triangles and tetrahedra, after measurements
/// (Mathematics 8): Loop's weights move vertices of four triangles farther.
constexpr double GetLeastEigenvalue(LoopWeights weights)
{
  return weights == LoopWeights::Loop ? 1. / 8. : 1. / 6.;
}

struct InterpolationLimits
{
  double LeastEigenvalue = 0.125; ///< set after measurements: Mathematics 8
  /// The error that a group may have, as a part of its range. It is never below the rounding of its
  /// values.
  double Tolerance = 1e-10;
  int MostProducts = 40;
  /// Sets values in rows that this part of a mesh does not have right to those that other parts
  /// have; empty where it has all.
  std::function<void(double* values, int components)> TakeOthers;
  /// Sets each value to the largest of all parts; empty where there is one part.
  std::function<void(std::vector<double>& values)> FindLargest;
};

/**
 * Columns with a common range and error: the components of an array, or those of several fields,
 * each of which has values in some rows only, and zeros elsewhere.
 */
struct InterpolationGroup
{
  int Components;
  int Fields = 1; ///< the columns are those of the first field, then those of the next one
  /// What the limits of each field are multiplied by in each row, to be means of values of the
  /// field; 0 where it has none. Null: all are 1.
  const double* Factors = nullptr;
  int Products = 0;  ///< of L, until the error was small enough
  double Error = 0.; ///< the largest distance of a limit from its value, as a part of the range
  bool HasConverged = false;
  std::vector<double> Range = {}; ///< the least and the largest value of each component
};

/**
 * Finds the shifts c - d. `given` has the columns of all groups, interleaved. A value that is not
 * finite, or whose limit would not be, is not shifted. A group that does not converge gets the
 * shifts with the least error.
 */
void FindInterpolation(const PointOperator& limit, const double* given,
  std::vector<InterpolationGroup>& groups, const InterpolationLimits& limits, double* shifts);

}

#endif
