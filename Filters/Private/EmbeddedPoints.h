// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EmbeddedPoints.h
 * How points hang in the subdivided rest mesh of a deformation.
 */
#ifndef SubdivisionObjects_EmbeddedPoints_h
#define SubdivisionObjects_EmbeddedPoints_h

#include "RestMesh.h"

namespace subdivision
{

/**
 * Each point is its row times the points of the subdivided mesh, plus, if it is outside, a
 * remainder that does not change: for a point that is left alone all of it (the row is empty), for
 * one that goes with its nearest place what is between the two.
 */
struct EmbeddedPoints
{
  SparseRows<int> Rows; ///< the corners of a cell: 4, 3 of a surface or curve, none
  /// The same over the control points, where reading these, and nothing else, is less; else empty.
  SparseRows<int> Composed;
  std::vector<vtkIdType> Outside;
  std::vector<double> Remainders; ///< 3 for each point outside
  vtkIdType NumberNotFinite = 0;  ///< of those outside

  std::vector<std::uint64_t> Fingerprint; ///< of the points
  OutsideRule Rule = OutsideRule::Leave;
  bool Used = true;
};

/// The largest number of points for which rows can be made.
constexpr vtkIdType MaximumNumberOfEmbeddedPoints = 536870911;

/// A point on faces that cells share belongs to the one with the smallest id.
std::unique_ptr<EmbeddedPoints> EmbedPoints(vtkDataArray* points, OutsideRule rule, RestMesh& rest);

/// The points as the mesh moves them: `control` and `moved` are what RestMesh makes of a shape;
/// `moved` may be null where there are composed rows.
vtkSmartPointer<vtkDataArray> MoveEmbeddedPoints(
  const EmbeddedPoints& embedded, vtkDataArray* control, vtkDataArray* moved, int type);

/// For each point the matrix (by rows) that the map of its cell is; 1 where there is no solid cell.
Buffer<double> ComputeJacobians(
  const EmbeddedPoints& embedded, const double* rest, const double* moved);

}

#endif
