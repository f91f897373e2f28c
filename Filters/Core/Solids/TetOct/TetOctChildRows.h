// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctChildRows.h
 * The same as ChildRows.h for tet/oct levels: the operators of the last two steps, applied without
 * being stored.
 */
#ifndef SubdivisionObjects_TetOctChildRows_h
#define SubdivisionObjects_TetOctChildRows_h

#include "Core/Solids/BoxSpline/ChildRows.h"
#include "Core/Solids/TetOct/TetOctStencils.h"

namespace subdivision
{

/// The operator that takes the level to the next.
template <typename Id>
class TetOctLevelRows : public RingOperator<Id>
{
public:
  explicit TetOctLevelRows(const TetOctLevel<Id>& level);
  vtkIdType GetNumberOfColumns() const override { return this->Stored.Vertices.size(); }
  vtkIdType GetNumberOfRows() const override { return this->Stored.GetNumberOfRows(); }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;

private:
  const StoredTetOctRows<Id> Stored;
};

/// The operator that takes values on the children of `level` to their children. `level` was made
/// with Depth::ForRefinement, or is the control level.
template <typename Id>
class TetOctChildRows : public RingOperator<Id>
{
public:
  explicit TetOctChildRows(const TetOctLevel<Id>& level)
    : Level(level)
  {
  }
  /// Numbers of vertices and edges of the children: first come the rows of the vertices, then those
  /// of the edges, then those of the octahedron centres.
  vtkIdType GetNumberOfVertices() const;
  vtkIdType GetNumberOfEdges() const;
  vtkIdType GetNumberOfColumns() const override { return this->GetNumberOfVertices(); }
  vtkIdType GetNumberOfRows() const override;
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;

private:
  const TetOctLevel<Id>& Level;
};

}

#endif
