// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TangentErrors.h
 * Bounds for the errors of tangents, and the normal of two tangents, which is zero where it would
 * consist of rounding errors only.
 */
#ifndef SubdivisionObjects_TangentErrors_h
#define SubdivisionObjects_TangentErrors_h

#include "Core/Memory/Coordinates.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/RowBlock.h"
#include "Core/Operators/ShadingNormals.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

namespace subdivision
{

/// Two tangents for each vertex, three numbers each, how far off both may be, and their normals if
/// somebody wants these.
struct TangentPairs
{
  explicit TangentPairs(vtkIdType size)
    : Values{ Buffer<double>(3 * size), Buffer<double>(3 * size) }
    , Errors(size, 0.)
  {
  }
  Buffer<double> Values[2];
  Buffer<double> Errors;
  Buffer<double> Normals;
};

/**
 * A bound for the error of a tangent, the sum over a row's weights w and points p. `unit` is the
 * largest relative error of a stored coordinate, so that storing the points of one level adds at
 * most unit |w| |p|. Errors of the level before count half, as a step halves tangents, and so on:
 * together at most 2 unit |w| |p|. Summing m products in double adds m 2^-53 |w| |p|. Each weight
 * is computed from a few sines, with an absolute error up to 2^-51 even if it should be 0.
 */
template <typename Id, typename Real>
double GetTangentError(
  const Id* columns, const double* weights, vtkIdType size, const Real* points, double unit)
{
  const double ofPoints = 2. * unit + static_cast<double>(size) * DoubleUnit;
  double error = 0.;
  for (vtkIdType k = 0; k < size; ++k)
  {
    const Real* p = points + 3 * static_cast<vtkIdType>(columns[k]);
    error += (ofPoints * std::abs(weights[k]) + 4. * DoubleUnit) *
      static_cast<double>(std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }));
  }
  return error;
}
template <typename Id, typename Real>
double GetTangentError(const RowBlock<Id>& rows, std::size_t row, const Real* points, double unit)
{
  const std::size_t begin = rows.GetBegin(row);
  return GetTangentError(rows.GetColumns() + begin, rows.GetWeights() + begin,
    static_cast<vtkIdType>(rows.GetEnd(row) - begin), points, unit);
}

/// The largest size of values that are no NaN.
template <typename Real>
double FindLargest(const Real* values, vtkIdType size)
{
  std::atomic<double> largest{ 0. };
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      const double own = std::accumulate(values + begin, values + end, Real(0),
        [](Real before, Real value) { return std::max(before, std::abs(value)); });
      double all = largest;
      while (all < own && !largest.compare_exchange_weak(all, own))
      {
      }
    });
  return largest;
}

/// A bound for GetTangentError where no coordinate is beyond `largest`; it does not read points.
inline double GetTangentBound(const double* weights, vtkIdType size, double largest, double unit)
{
  const double sum = std::accumulate(
    weights, weights + size, 0., [](double before, double w) { return before + std::abs(w); });
  const auto entries = static_cast<double>(size);
  return largest * (1.01 * (2. * unit + entries * DoubleUnit) * sum + 4.01 * DoubleUnit * entries);
}

/// FindNormal where this takes few operations. False: the tangents may be parallel within `error`,
/// or their squares are too large or too small.
[[gnu::always_inline]] inline bool FindClearNormal(
  const double* a, const double* b, double error, double normal[3])
{
  const auto square = [](const double* x) { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; };
  const double across[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  const double length = square(across);
  // The square of a sum of three is at most three times the sum of squares.
  const double least = 3.01 * error * error * (square(a) + square(b) + error * error);
  if (!(length > least && length > 1e-200 && length < 1e200))
  {
    return false;
  }
  const double factor = 1. / std::sqrt(length);
  for (int c = 0; c < 3; ++c)
  {
    normal[c] = factor * across[c];
  }
  return true;
}

/// The unit normal of two tangents, or zero where the tangents may be parallel within `error` and
/// so span no plane.
inline void FindNormal(const double* a, const double* b, double error, double normal[3])
{
  normal[0] = a[1] * b[2] - a[2] * b[1];
  normal[1] = a[2] * b[0] - a[0] * b[2];
  normal[2] = a[0] * b[1] - a[1] * b[0];
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const double least =
    error * (std::hypot(a[0], a[1], a[2]) + std::hypot(b[0], b[1], b[2]) + error);
  for (int c = 0; c < 3; ++c)
  {
    normal[c] = length > least && std::isfinite(length) ? normal[c] / length : 0.;
  }
}

/// The unit normal of two tangents, or where they may be parallel one that is perpendicular to the
/// longer tangent; reversed if it is turned. getError(isBound): how far off both tangents are
/// together, or a bound for that which takes few operations.
template <typename GetError>
void FindSectorNormal(
  const double* a, const double* b, const GetError& getError, bool isTurned, double normal[3])
{
  if (!FindClearNormal(a, b, getError(true), normal))
  {
    FindNormal(a, b, getError(false), normal);
    if (std::hypot(normal[0], normal[1], normal[2]) == 0.)
    {
      FindPerpendicular(
        std::hypot(a[0], a[1], a[2]) < std::hypot(b[0], b[1], b[2]) ? b : a, normal);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    normal[c] = isTurned ? -normal[c] : normal[c];
  }
}

}

#endif
