// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TangentErrors.h
 * Bounds for the errors of tangents, and the normal of two tangents, which is zero where it would
 * consist of rounding errors only.
 */
#ifndef SubdivisionObjects_TangentErrors_h
#define SubdivisionObjects_TangentErrors_h

#include "Core/Memory/Coordinates.h"
#include "Core/Operators/RowBlock.h"

#include <algorithm>
#include <cmath>

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
template <typename Id>
double GetTangentError(
  const Id* columns, const double* weights, vtkIdType size, const double* points, double unit)
{
  const double ofPoints = 2. * unit + static_cast<double>(size) * DoubleUnit;
  double error = 0.;
  for (vtkIdType k = 0; k < size; ++k)
  {
    const double* p = points + 3 * static_cast<vtkIdType>(columns[k]);
    error += (ofPoints * std::abs(weights[k]) + 4. * DoubleUnit) *
      std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return error;
}
template <typename Id>
double GetTangentError(const RowBlock<Id>& rows, std::size_t row, const double* points, double unit)
{
  const std::size_t begin = rows.GetBegin(row);
  return GetTangentError(rows.GetColumns() + begin, rows.GetWeights() + begin,
    static_cast<vtkIdType>(rows.GetEnd(row) - begin), points, unit);
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

}

#endif
