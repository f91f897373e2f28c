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

#include <functional>

namespace subdivision
{

/// Receives a block of rows (StencilRows or TetOctRows). ForRows passes each row exactly once, in
/// any order and from several threads.
template <typename Rows>
using RowsUser = std::function<void(const Rows&)>;

/// An operator that passes its rows block by block to a function.
template <typename Rows>
class RowsOnTheFly
{
public:
  virtual ~RowsOnTheFly() = default;
  virtual vtkIdType GetNumberOfRows() const = 0;
  virtual void ForRows(const RowsUser<Rows>& use) const = 0;
};

/// The operator that takes a level to the next.
template <typename Id>
class LevelRows : public RowsOnTheFly<StencilRows<Id>>
{
public:
  explicit LevelRows(const subdivision::Level<Id>& level)
    : Level(level)
  {
  }
  vtkIdType GetNumberOfRows() const override;
  void ForRows(const RowsUser<StencilRows<Id>>& use) const override;

private:
  const subdivision::Level<Id>& Level;
};

/// The operator that takes values on the children of `level` to their children. `level` was made
/// with Depth::ForRefinement, or is the control level.
template <typename Id>
class ChildRows : public RowsOnTheFly<StencilRows<Id>>
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
  vtkIdType GetNumberOfRows() const override
  {
    return this->GetNumberOfVertices() + this->GetNumberOfEdges();
  }
  void ForRows(const RowsUser<StencilRows<Id>>& use) const override;

private:
  const subdivision::Level<Id>& Level;
};

}

#endif
