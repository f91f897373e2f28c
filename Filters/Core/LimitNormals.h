// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitNormals.h
 * Tangents and normals of limit surfaces: of surfaces and of the boundaries of solids (SPEC 8).
 *
 * The vertex and its neighbours in cyclic order p_0, p_1, ... have the tangents sum cos(2 pi j/m)
 * p_j and sum sin(2 pi j/m) p_j. A vertex on a boundary or crease has one or two *sectors*, each
 * from one sharp edge to the next; the tangents of a sector of k triangles are along the curve, p_0
 * - p_k, and across it, with the weights sin(pi j/k) of p_1 to p_k-1 and those of the ends and of
 * the vertex that make it a left eigenvector (of 3/8 + 1/4 cos(pi/k)). Several sectors: the mean of
 * their normals. Corners, curves, the inside of solids, joints, darts, and vertices of semi-sharp
 * creases that are still sharp have no normal.
 */
#ifndef SubdivisionObjects_LimitNormals_h
#define SubdivisionObjects_LimitNormals_h

#include "LimitStencils.h"

namespace subdivision
{

template <typename Id>
struct LimitTangents
{
  Rows<Id> Sectors; ///< of each vertex; Items are not used: sectors are numbered through
  /// One row for each sector; their cross product has the orientation of the surface's triangle
  /// with the smallest number.
  SparseRows<Id> First;
  SparseRows<Id> Second;
  /// Where it bounds a solid: three vertices for each triangle of the sector, those beside the
  /// vertex in the order in which the cross product sees them, and the one inside.
  Rows<Id> Inside;

  vtkIdType GetNumberOfSectors() const { return this->First.GetNumberOfRows(); }
  std::size_t GetMemorySize() const
  {
    return this->Sectors.GetMemorySize() + this->First.GetMemorySize() +
      this->Second.GetMemorySize() + this->Inside.GetMemorySize();
  }
};

/// The tangents at all vertices of a level that can be refined (Depth::ForRefinement).
template <typename Id>
LimitTangents<Id> BuildLimitTangents(
  const Level<Id>& level, const SemiSharpStages<Id>& creases = {});

template <typename Id>
LimitTangents<Id> BuildLimitTangents(
  const TetOctLevel<Id>& level, const SemiSharpStages<Id>& creases = {});

/// Unit normals, three numbers for each vertex, from the points of the level; outwards where the
/// surface bounds a solid; zero where there is none.
template <typename Id>
void ComputeLimitNormals(const LimitTangents<Id>& tangents, const double* points, double* normals);

}

#endif
