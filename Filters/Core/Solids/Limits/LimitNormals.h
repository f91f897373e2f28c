// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitNormals.h
 * Tangents and normals of limit surfaces: of surfaces and of the boundaries of solids (Mathematics
 * 8).
 *
 * The vertex and its neighbours in cyclic order p_0, p_1, ... have the tangents sum cos(2 pi j/m)
 * p_j and sum sin(2 pi j/m) p_j. A vertex on a boundary or crease has one or two *sectors*, each
 * from one sharp edge to the next; the tangents of a sector of k triangles are along the curve, p_0
 * - p_k, and across it, with the weights sin(pi j/k) of p_1 to p_k-1 and those of the ends and of
 * the vertex that make it a left eigenvector (of 3/8 + 1/4 cos(pi/k)). Several sectors: the mean of
 * their normals. From 7 triangles on a sector has no tangent plane: the second wave, of eigenvalue
 * 3/8 + 1/4 cos(2 pi/k), then shrinks more slowly than the curve, by more than 1/2. Corners,
 * curves, joints, darts, and vertices of semi-sharp creases that are still sharp have no tangent
 * plane, and take a normal for shading from what is around them. Inside solids it is zero.
 */
#ifndef SubdivisionObjects_LimitNormals_h
#define SubdivisionObjects_LimitNormals_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Limits/ShadingFacets.h"

#include <vector>

namespace subdivision
{

template <typename Id>
struct LimitTangents
{
  Rows<Id> Sectors; ///< of each vertex; Items are not used: sectors are numbered
                    ///< consecutively over all vertices
  /// One row for each sector; their cross product has the orientation of the first triangle of its
  /// part or, where it bounds a solid, that of the walk around the vertex.
  SparseRows<Id> First;
  SparseRows<Id> Second;
  /// Where it bounds a solid: of each of its triangles twice the number of the control tetrahedron
  /// behind it, and one more if that is in front where the cross product points, as far as the
  /// order of vertices tells. So smoothing, which may turn solids inside out, turns no normal.
  Buffer<vtkIdType> SideOffsets;
  Buffer<vtkIdType> Sides;
  /// At the vertices that have no sector.
  ShadingFacets<Id> Shading;

  vtkIdType GetNumberOfSectors() const { return this->First.GetNumberOfRows(); }
  std::size_t GetMemorySize() const
  {
    return this->Sectors.GetMemorySize() + this->First.GetMemorySize() +
      this->Second.GetMemorySize() + this->SideOffsets.GetMemorySize() +
      this->Sides.GetMemorySize() + this->Shading.GetMemorySize();
  }
};

/// What the tetrahedra of the control mesh are called, in the order of the complex (empty: their
/// numbers there), and how many steps there are from the control level to the level.
struct ControlSolids
{
  std::vector<vtkIdType> Numbers;
  int Steps = 0;
};

/// The tangents at all vertices of a level that can be refined (Depth::ForRefinement).
template <typename Id>
LimitTangents<Id> BuildLimitTangents(const Level<Id>& level,
  const SemiSharpStages<Id>& creases = {}, const ControlSolids& solids = {});

template <typename Id>
LimitTangents<Id> BuildLimitTangents(const TetOctLevel<Id>& level,
  const SemiSharpStages<Id>& creases = {}, const ControlSolids& solids = {});

/// Unit normals, three numbers for each vertex, from the points of the level. Where there is none,
/// one for shading (ShadingNormals.h), but zero inside solids. `inverted`: twice the number of each
/// control tetrahedron that has a negative volume, ascending; odd numbers mean nothing.
template <typename Id>
void ComputeLimitNormals(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, double* normals);

}

#endif
