// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalLimit.h
 * Computes limits of some vertices of the uniform refinement of a level without making levels: rows
 * and limits follow from where vertices lie (SharpLattice.h, LatticeNormals.h).
 *
 * The caller names a vertex by the two ends of the edge whose midpoint it is. So it needs no ids of
 * the uniform refinement, which would overflow on deep levels. The limit row of a vertex is taken
 * on the level on which the vertex first exists. Then the program goes back from the finest level
 * to the control level and keeps of each the vertices that rows read.
 */
#ifndef SubdivisionObjects_LocalLimit_h
#define SubdivisionObjects_LocalLimit_h

#include "Core/Solids/Limits/LimitNormals.h"
#include "Core/Solids/Limits/LimitStencils.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
class LocalLimit : public PointOperator
{
public:
  /**
   * Vertices 0 to V - 1 are those of `control` (made with Depth::ForRefinement, or the control
   * level), which has V. Vertex V + i is the edge point of the edge between the vertices
   * `midpoints[i]`, both smaller than V + i. It must be an edge of a level of the uniform
   * refinement (RedGreen::GetEnds) or, in the tet/oct scheme, the diagonal of an octahedron of a
   * level, whose centre the vertex then is. Only ends that lie in no cell are noticed, by
   * std::invalid_argument, and not whether they have an edge. The same edge may occur again. Of
   * equal ends a, V + i is the vertex a as one of the level after that of a: so limits of vertices
   * that are close together can all be those on one level. `solids`: for ComputeNormals; null: it
   * is not called.
   */
  template <typename LevelType>
  LocalLimit(const LevelType& control, const SemiSharpStages<Id>& creases,
    const std::vector<std::array<Id, 2>>& midpoints, const ControlSolids* solids = nullptr);

  /// Computes the unit normals of all vertices, three numbers for each, from the points of the
  /// control level. `inverted` and `turned` as in ComputeLimitNormals. They are taken, like limits,
  /// on the level on which a vertex first exists: normals by tangents are the same on all levels
  /// but for rounding, and normals for shading do not depend on other vertices that are refined.
  void ComputeNormals(const Coordinates& points, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned, double* normals) const;

  /// Control vertices, then midpoints.
  vtkIdType GetNumberOfRows() const override { return this->NumberOfRows; }
  vtkIdType GetNumberOfColumns() const override { return this->NumberOfColumns; }

  /// Of values between two levels at a time are kept.
  vtkIdType GetNumberBetween() const override;
  void ForEachBlock(const User& use) const override;

  // The levels, from the control level on:
  int GetNumberOfLevels() const { return static_cast<int>(this->Steps.size()); }
  /// The vertices that first exist on a level, and their limits over the level's values.
  const std::vector<Id>& GetVertices(int level) const { return this->Steps[level].Vertices; }
  const SparseRows<Id>& GetLimitsOnLevel(int level) const { return this->Steps[level].Limits; }
  /// The level's values over those before it, on level 0 over the control vertices.
  const SparseRows<Id>& GetRowsOfLevel(int level) const { return this->Steps[level].Rows; }

private:
  /// One step, and the limits of the vertices that first exist on its level.
  struct Step
  {
    SparseRows<Id> Rows;   ///< from values of the step before; the first ones copy control values
    SparseRows<Id> Limits; ///< from this step's values
    std::vector<Id> Vertices;
    LimitTangents<Id> Tangents; ///< of the same vertices, for normals
  };
  template <typename LevelType>
  class Builder;
  std::array<vtkIdType, 2> GetSizesBetween() const;

  vtkIdType NumberOfRows = 0;
  vtkIdType NumberOfColumns = 0;
  std::vector<Step> Steps;
};

}

#endif
