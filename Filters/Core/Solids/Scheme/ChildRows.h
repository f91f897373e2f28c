// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildRows.h
 * The operator of a level that is never made.
 *
 * Let a level be given from which two more steps are made. LevelRows is its own operator, ChildRows
 * the operator of the next level. This next level is never made: ChildRows makes a few rows at a
 * time from the given level, in memory that stays in the processor's cache, and all arrays are
 * summed with them at once. The rows and the order of their rings are those that Refine would
 * store. A scheme compiles ChildRows with ChildRowsMaker.h.
 */
#ifndef SubdivisionObjects_ChildRows_h
#define SubdivisionObjects_ChildRows_h

#include "Core/Operators/PointOperator.h"
#include "Core/Solids/Scheme/SolidParts.h"

namespace subdivision
{

/// The operator that takes values on the children of `level` to their children. `level` was made
/// with Depth::ForRefinement, or is the control level. `Split` as in Refiner.h.
template <typename Split>
class ChildRows : public RingOperator<typename Split::Id>
{
public:
  using Id = typename Split::Id;

  explicit ChildRows(const typename Split::Level& level)
    : Level(level)
    , Ids(level)
  {
  }
  /// Numbers of vertices and edges of the children: first come the rows of the vertices, then those
  /// of the edges, then those of the centres of solids.
  vtkIdType GetNumberOfVertices() const { return this->Ids.GetNumberOfVertices(); }
  vtkIdType GetNumberOfEdges() const { return this->Ids.GetNumberOfEdges(); }
  vtkIdType GetNumberOfColumns() const override { return this->GetNumberOfVertices(); }
  vtkIdType GetNumberOfRows() const override
  {
    vtkIdType rows = this->GetNumberOfVertices() + this->GetNumberOfEdges();
    ForShapes(typename Split::Shapes(),
      [&](auto shape)
      {
        using Shape = decltype(shape);
        rows += Shape::Centres * vtkIdType(this->Ids.GetNumberOfChildren(Shape::Index));
      });
    return rows;
  }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;

private:
  const typename Split::Level& Level;
  const ChildIds<Split> Ids;
};

}

#endif
