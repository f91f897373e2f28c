// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildRows.h
 * The operators of a level and of its children, applied without being stored.
 *
 * The last step needs nothing of its level but its cells and one product with its operator. So that
 * level is never made: a few rows of its operator at a time are made from the level before, in
 * memory that stays in the cache, and summed for all arrays. They are the rows, in rings of the
 * same order, that Refine would store.
 */
#ifndef SubdivisionObjects_ChildRows_h
#define SubdivisionObjects_ChildRows_h

#include "Core/Solids/BoxSpline/Stencils.h"

#include <functional>

namespace subdivision
{

/// Is called with all rows of an operator, some at a time, in any order and from several threads.
/// Rows are StencilRows or TetOctRows.
template <typename Rows>
using RowsUser = std::function<void(const Rows&)>;

/// An operator that hands its rows over.
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

/// The operator that takes the children of a level, which has all that a further step needs, to
/// theirs.
template <typename Id>
class ChildRows : public RowsOnTheFly<StencilRows<Id>>
{
public:
  explicit ChildRows(const subdivision::Level<Id>& level)
    : Level(level)
  {
  }
  /// Of the children: the rows of their vertices come first, then those of their edges.
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
