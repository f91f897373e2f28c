// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EmbeddedPoints.h
 * How points hang in the subdivided rest mesh of a deformation.
 */
#ifndef SubdivisionObjects_EmbeddedPoints_h
#define SubdivisionObjects_EmbeddedPoints_h

#include "Core/Operators/CornerRows.h"
#include "Private/Deformation/RestMesh.h"

namespace subdivision
{

/**
 * Each point is its row times the points of the subdivided mesh, plus, if it is outside, a
 * remainder that does not change: for a point that is left alone all of it (the row is empty), for
 * one that goes with its nearest place what is between the two.
 */
struct EmbeddedPoints
{
  CornerRows Rows; ///< of cells: 4 corners, 3 of a surface or curve, none
  /// The same over the control points, where reading these, and nothing else, is less; else empty.
  SparseRows<int> Composed;
  std::vector<vtkIdType> Outside;
  std::vector<double> Remainders; ///< 3 for each point outside
  vtkIdType NumberNotFinite = 0;  ///< of those outside

  std::vector<std::uint64_t> Fingerprint; ///< of the points
  OutsideRule Rule = OutsideRule::Leave;
  bool Used = true;
};

/// A point on faces that cells share belongs to the one with the smallest id.
std::unique_ptr<EmbeddedPoints> EmbedPoints(vtkDataArray* points, OutsideRule rule, RestMesh& rest);

/// The points as the mesh moves them, from the control points and those of the subdivided mesh in
/// the other shape; `moved` may be null where there are composed rows.
vtkSmartPointer<vtkDataArray> MoveEmbeddedPoints(
  const EmbeddedPoints& embedded, const double* control, const double* moved, int type);

/// For each point the matrix (by rows) that the map of its cell is; 1 where there is no solid cell.
Buffer<double> ComputeJacobians(
  const EmbeddedPoints& embedded, const double* rest, const double* moved);

}

#endif
