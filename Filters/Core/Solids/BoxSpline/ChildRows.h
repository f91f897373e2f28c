// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildRows.h
 * The operators of the last two steps, applied without being stored.
 *
 * Let a level be given from which two more steps are made. LevelRows is its own operator, ChildRows
 * the operator of the next level. This next level is never made: ChildRows makes a few rows at a
 * time from the given level, in memory that stays in the processor's cache, and all arrays are
 * summed with them at once. The rows and the order of their rings are those that Refine would
 * store.
 */
#ifndef SubdivisionObjects_ChildRows_h
#define SubdivisionObjects_ChildRows_h

#include "Core/Solids/BoxSpline/Stencils.h"

namespace subdivision
{

/// The operator that takes a level to the next.
template <typename Id>
class LevelRows : public RingOperator<Id>
{
public:
  explicit LevelRows(const subdivision::Level<Id>& level)
    : Level(level)
  {
  }
  vtkIdType GetNumberOfColumns() const override;
  vtkIdType GetNumberOfRows() const override;
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;

private:
  const subdivision::Level<Id>& Level;
};

/// The operator that takes values on the children of `level` to their children. `level` was made
/// with Depth::ForRefinement, or is the control level.
template <typename Id>
class ChildRows : public RingOperator<Id>
{
public:
  explicit ChildRows(const subdivision::Level<Id>& level)
    : Level(level)
  {
  }
  /// Numbers of vertices and edges of the children: first come the rows of the vertices, then those
  /// of the edges.
  vtkIdType GetNumberOfVertices() const;
  vtkIdType GetNumberOfEdges() const;
  vtkIdType GetNumberOfColumns() const override { return this->GetNumberOfVertices(); }
  vtkIdType GetNumberOfRows() const override
  {
    return this->GetNumberOfVertices() + this->GetNumberOfEdges();
  }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;

private:
  const subdivision::Level<Id>& Level;
};

}

#endif
