// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctChildRows.h
 * The operators of a tet/oct level and of its children, applied without being stored, as those of
 * ChildRows.h are.
 */
#ifndef SubdivisionObjects_TetOctChildRows_h
#define SubdivisionObjects_TetOctChildRows_h

#include "Core/Solids/BoxSpline/ChildRows.h"
#include "Core/Solids/TetOct/TetOctStencils.h"

namespace subdivision
{

/// The operator that takes the level to the next.
template <typename Id>
class TetOctLevelRows : public RowsOnTheFly<TetOctRows<Id>>
{
public:
  explicit TetOctLevelRows(const TetOctLevel<Id>& level);
  vtkIdType GetNumberOfRows() const override { return this->Stored.GetNumberOfRows(); }
  void ForRows(const RowsUser<TetOctRows<Id>>& use) const override;

private:
  const StoredTetOctRows<Id> Stored;
};

/// The operator that takes the children of a level, which has all that a further step needs, to
/// theirs.
template <typename Id>
class TetOctChildRows : public RowsOnTheFly<TetOctRows<Id>>
{
public:
  explicit TetOctChildRows(const TetOctLevel<Id>& level)
    : Level(level)
  {
  }
  /// Of the children: the rows of their vertices come first, then those of their edges.
  vtkIdType GetNumberOfVertices() const;
  vtkIdType GetNumberOfEdges() const;
  vtkIdType GetNumberOfRows() const override;
  void ForRows(const RowsUser<TetOctRows<Id>>& use) const override;

private:
  const TetOctLevel<Id>& Level;
};

}

#endif
