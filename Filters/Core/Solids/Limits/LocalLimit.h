// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalLimit.h
 * Computes limits of some vertices of the uniform refinement of a level. It makes only those parts
 * of the refined levels that these limits depend on.
 *
 * The caller names a vertex by the two ends of the edge whose midpoint it is. So it needs no ids of
 * the uniform refinement, which would overflow on deep levels. In each step the current part of the
 * level is restricted to the cells around *ancestors*, the vertices between which later vertices
 * arise (Restriction.h), and refined with the usual rules and rings. The limit row of a vertex is
 * taken on the level on which the vertex first exists (LimitStencils.h). Then the program goes back
 * from the limits to the control level and keeps only the rows that are ancestors. If the part was
 * too small for one of these, so that the row lacks entries, all is repeated with a larger
 * distance.
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
   * level, whose centre the vertex then is; else std::invalid_argument is thrown. The same edge may
   * occur again. Of equal ends a, V + i is the vertex a as one of the level after that of a: so
   * limits of vertices that are close together can all be those on one level. `wanted` flags the
   * vertices whose limits are computed (empty: all); Apply leaves the values of the others.
   * `distance`: at first a part has all vertices within this number of edges of its ancestors.
   * `solids`: for ComputeNormals; null: it is not called.
   */
  template <typename LevelType>
  LocalLimit(const LevelType& control, const SemiSharpStages<Id>& creases,
    const std::vector<std::array<Id, 2>>& midpoints,
    const Buffer<unsigned char>& wanted = Buffer<unsigned char>(), int distance = 1,
    const ControlSolids* solids = nullptr);

  /// The same without making levels: rows follow from where vertices lie (SharpLattice.h). There
  /// are no normals. Only ends that lie in no cell are noticed, and not whether they have an edge.
  template <typename LevelType>
  static LocalLimit MakeOnLattice(const LevelType& control, const SemiSharpStages<Id>& creases,
    const std::vector<std::array<Id, 2>>& midpoints,
    const Buffer<unsigned char>& wanted = Buffer<unsigned char>());

  /// Computes the unit normals of wanted vertices, three numbers for each vertex, from the points
  /// of the control level. `inverted` and `turned` as in ComputeLimitNormals. They are taken, like
  /// limits, on the level on which a vertex first exists: normals by tangents are the same on all
  /// levels but for rounding, and normals for shading do not depend on other vertices that are
  /// refined.
  void ComputeNormals(const Coordinates& points, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned, double* normals) const;

  /// Control vertices, then midpoints.
  vtkIdType GetNumberOfRows() const override { return this->NumberOfRows; }
  vtkIdType GetNumberOfColumns() const override { return this->NumberOfColumns; }

  /// Of values between two levels at a time are kept. Only rows of wanted vertices are passed.
  vtkIdType GetNumberBetween() const override;
  void ForEachBlock(const User& use) const override;

  // The levels, from the control level on:
  int GetNumberOfLevels() const { return static_cast<int>(this->Steps.size()); }
  /// The wanted vertices that first exist on a level, and their limits over the level's values.
  const std::vector<Id>& GetVertices(int level) const { return this->Steps[level].Vertices; }
  const SparseRows<Id>& GetLimitsOnLevel(int level) const { return this->Steps[level].Limits; }
  /// The level's values over those before it, on level 0 over the control vertices.
  const SparseRows<Id>& GetRowsOfLevel(int level) const { return this->Steps[level].Rows; }

private:
  LocalLimit() = default;

  /// One step, and the limits of the wanted vertices that first exist on its level.
  struct Step
  {
    SparseRows<Id> Rows;   ///< from values of the step before; the first ones copy control values
    SparseRows<Id> Limits; ///< from this step's values
    std::vector<Id> Vertices;
    LimitTangents<Id> Tangents; ///< of the same vertices, from this step's values
  };
  template <typename LevelType>
  class Builder;
  template <typename LevelType>
  class LatticeBuilder;
  std::array<vtkIdType, 2> GetSizesBetween() const;

  vtkIdType NumberOfRows = 0;
  vtkIdType NumberOfColumns = 0;
  std::vector<Step> Steps;
};

}

#endif
