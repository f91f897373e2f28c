// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Interpolation.h
 * Control values whose limits are given values: the solution of L c = d, where L has a limit row
 * for each control vertex (Mathematics 8, Interpolation). Where some vertices are free, only the
 * control values of the others change, and the system has their rows and columns alone.
 *
 * The solver is Chebyshev iteration. It multiplies by L and knows two bounds of its eigenvalues. It
 * needs no inner products, so that the bits of the result depend neither on the number of threads
 * nor on other columns. Rows of L are means, so that no eigenvalue exceeds 1. The lower bound is a
 * guess: with smaller eigenvalues, as long as they are positive, the iteration converges more
 * slowly. Columns for which it is too slow are solved for directly (DirectSolver.h), if L has
 * factors that fit into memory.
 */
#ifndef SubdivisionObjects_Interpolation_h
#define SubdivisionObjects_Interpolation_h

#include "Core/Operators/PointOperator.h"
#include "Core/Rules/LoopWeights.h"

#include <functional>
#include <numeric>
#include <vector>

namespace subdivision
{

/// The smallest eigenvalue that the solver expects on triangles and tetrahedra, from measurements
/// (Mathematics 8): Loop's weights move vertices of four triangles farther.
constexpr double GetLeastEigenvalue(LoopWeights weights)
{
  return weights == LoopWeights::Loop ? 1. / 8. : 1. / 6.;
}

/// The rows of all parts of a mesh as rows of one matrix, with which one part solves.
struct WholeSystem
{
  /// Where there is one part.
  explicit WholeSystem(vtkIdType size)
    : Size(size)
    , Numbers(static_cast<std::size_t>(size))
    , AreOwn(static_cast<std::size_t>(size), 1)
  {
    std::iota(this->Numbers.begin(), this->Numbers.end(), vtkIdType(0));
  }

  vtkIdType Size;
  std::vector<vtkIdType> Numbers; ///< of the rows here; -1 where no part has the row
  std::vector<char> AreOwn;       ///< which rows are right here
  /// Replaces numbers by the numbers of all parts one after the other, in the part that solves.
  /// Returns whether this one does.
  std::function<bool(std::vector<double>&)> ToSolver = [](std::vector<double>&) { return true; };
  /// Replaces numbers by the numbers of the part that solves.
  std::function<void(std::vector<double>&)> FromSolver = [](std::vector<double>&) {};
};

struct InterpolationLimits
{
  double LeastEigenvalue = 0.125; ///< set after measurements: Mathematics 8
  /// The error that a group may have, as a fraction of its range. It is never below the rounding of
  /// its values.
  double Tolerance = 1e-10;
  int MostProducts = 40;
  /// For each row which part of the way from its limit to its value the limit goes; 0: its control
  /// value stays. Null: all go the whole way.
  const double* Parts = nullptr;
  /// Sets values in rows that this part of a mesh does not have right to the values of other parts;
  /// empty where it has all rows.
  std::function<void(double* values, int components)> TakeOthers;
  /// Sets each value to the largest of all parts; empty where there is one part.
  std::function<void(std::vector<double>& values)> FindLargest;
  /// Makes the whole of the parts; empty where there is one.
  std::function<WholeSystem()> FindWhole;
  /// How many bytes a direct solution may take; empty: any number.
  std::function<double()> FindMemory;
};

/**
 * Columns with a common range and error: the components of an array, or of several fields, each of
 * which has values in some rows only, and zeros elsewhere.
 */
struct InterpolationGroup
{
  int Components;
  int Fields = 1; ///< first the columns of the first field, then of the next one
  /// Factors of the limits of each field in each row, which turn them into means of values of the
  /// field; 0 where it has no value. Null: all are 1.
  const double* Factors = nullptr;
  /// The material of each field in each row, from 0 to NumberOfMaterials - 1: each has a range of
  /// its own. Null: all are one.
  const int* Materials = nullptr;
  int NumberOfMaterials = 1;
  int Products = 0;  ///< of L, until the error was small enough
  double Error = 0.; ///< the largest distance of a limit from its value, as a fraction of the range
  bool HasConverged = false;
  bool IsTooLarge = false;        ///< to be solved for directly
  std::vector<double> Range = {}; ///< the least and the largest value of each component
};

/**
 * Finds the shifts c - d. `given` has the columns of all groups, interleaved. A value that is not
 * finite, or whose limit would not be, is not shifted, and all others are solved for without it. A
 * group that neither converges nor has a direct solution gets the shifts of the iteration, or none.
 */
void FindInterpolation(const PointOperator& limit, const double* given,
  std::vector<InterpolationGroup>& groups, const InterpolationLimits& limits, double* shifts);

}

#endif
