// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EmbeddedPoints.h
 * Binds points to the cells of the subdivided rest mesh of a deformation.
 */
#ifndef SubdivisionObjects_EmbeddedPoints_h
#define SubdivisionObjects_EmbeddedPoints_h

#include "Core/Operators/CornerRows.h"
#include "Private/Arrays/Fingerprint.h"
#include "Private/Deformation/RestMesh.h"
#include "Private/Run/KeptEntries.h"

#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace subdivision
{

/**
 * A point inside is its row times the points of the subdivided mesh. A point outside also has a
 * remainder that does not change. If it is left where it is the row is empty and the remainder is
 * the point; if it moves like the nearest place in the mesh the remainder is the difference between
 * the two.
 */
struct EmbeddedPoints : KeptEntry
{
  /// Corners of cells: 4 of a solid, 3 of another cell, or none. They read corners of the rest
  /// mesh, of which these points are forgotten before it changes.
  CornerRows Rows;
  /// The same rows over the control points, if they are read faster than rows and operators; else
  /// empty.
  SparseRows<int> Composed;
  /// On the limit there are these rows over the control points alone: of the values and, where
  /// somebody wants them, of the derivatives by the parameters of the place. Left points have none.
  std::array<SparseRows<vtkIdType>, 4> OnLimit;
  std::vector<char> IsLeft;
  std::vector<vtkIdType> Outside;
  std::vector<double> Remainders; ///< 3 for each point outside
  vtkIdType NumberNotFinite = 0;  ///< of the points outside

  Fingerprint Print; ///< of the points
  OutsideRule Rule = OutsideRule::Leave;

  /// How many rows Rows.Others may have, which are named by int; tests change it.
  static inline vtkIdType MostOthers = std::numeric_limits<int>::max();

  bool IsOnLimit() const { return this->OnLimit[0].GetNumberOfRows() > 0; }
  vtkIdType GetNumberOfPoints() const
  {
    return this->IsOnLimit() ? this->OnLimit[0].GetNumberOfRows() : this->Rows.GetNumberOfRows();
  }
  bool IsBound(vtkIdType i) const
  {
    return this->IsOnLimit() ? this->IsLeft[i] == 0 : !this->Rows.IsEmpty(i);
  }
  std::size_t GetMemorySize() const override
  {
    return std::accumulate(this->OnLimit.begin(), this->OnLimit.end(),
      this->Rows.GetMemorySize() + this->Composed.GetMemorySize(),
      [](std::size_t sum, const auto& rows) { return sum + rows.GetMemorySize(); });
  }
};

/// Embeds points. A point on a common face of cells belongs to the one with the smallest id. Null:
/// more than MostOthers points are in no solid, and need a row of their own.
std::unique_ptr<EmbeddedPoints> EmbedPoints(vtkDataArray* points, OutsideRule rule, RestMesh& rest);

/// Embeds points by their places on the limit (LimitPoints.cxx). `slopes`: whether derivatives are
/// wanted. Null after an error (passed to Fail).
std::unique_ptr<EmbeddedPoints> EmbedOnLimit(
  vtkDataArray* points, bool slopes, const DeformationOptions& options, RestMesh& rest);

/// Moves the points. `control`: control points of the deformed mesh; `moved`: points of the
/// subdivided deformed mesh, or null where there are composed rows.
vtkSmartPointer<vtkDataArray> MoveEmbeddedPoints(
  const EmbeddedPoints& embedded, const double* control, const double* moved, int type);

/// The same by `moved`, and meanwhile the fingerprint of `given`, points in single or double
/// precision that may be the embedded ones. Null: it is another.
vtkSmartPointer<vtkDataArray> MoveIfEmbedded(
  const EmbeddedPoints& embedded, const double* moved, int type, vtkDataArray* given);

/// For each point the Jacobian matrix (row by row) of the affine map of its cell or, on the limit,
/// of the map itself; the identity where it has no solid cell. `rest`, `moved`: the points of the
/// subdivided mesh, on the limit the control points.
Buffer<double> ComputeJacobians(
  const EmbeddedPoints& embedded, const double* rest, const double* moved);

}

#endif
