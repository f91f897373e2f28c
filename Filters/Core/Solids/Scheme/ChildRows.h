// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildRows.h
 * The operator of a level that is never made.
 *
 * Let a level be given from which two more steps are made. LevelRows is its own operator, ChildRows
 * the operator of the next level. This next level is never made: ChildRows makes a few rows at a
 * time from the given level, in memory that stays in the processor's cache, and all arrays are
 * summed with them at once. Refine would store the same rows, with the same order of rings. A
 * scheme compiles ChildRows with ChildRowsMaker.h.
 */
#ifndef SubdivisionObjects_ChildRows_h
#define SubdivisionObjects_ChildRows_h

#include "Core/Operators/PointOperator.h"
#include "Core/Solids/Scheme/SolidParts.h"

namespace subdivision
{

/// Parts of a level whose children alone get rows. The rows have the numbers that they would have
/// if these parts were the level.
template <typename Split>
struct ChildSelection
{
  using Id = typename Split::Id;

  const Buffer<Id>& Vertices; ///< numbers in the level
  const Buffer<Id>& Edges;
  const Buffer<Id>& Faces;
  std::array<const Buffer<Id>*, Split::Shapes::Size> Solids; ///< of each shape
  ChildIds<Split> Ids;                                       ///< of the children of the parts
};

/// The operator that takes values on the children of `level` to their children. `level` was made
/// with Depth::ForRefinement, or is the control level. `Split` as in Refiner.h. `selection`: null:
/// all children get rows.
template <typename Split>
class ChildRows : public RingOperator<typename Split::Id>
{
public:
  using Id = typename Split::Id;
  using Ids = ChildIds<Split>;
  using Selected = ChildSelection<Split>;

  explicit ChildRows(const typename Split::Level& level, const Selected* selection = nullptr)
    : Level(level)
    , LevelIds(level)
    , Selection(selection)
  {
  }
  /// Numbers of vertices and edges of the children: first come the rows of the vertices, then of
  /// the edges, then of the centres of solids.
  vtkIdType GetNumberOfVertices() const { return this->GetRowIds().GetNumberOfVertices(); }
  vtkIdType GetNumberOfEdges() const { return this->GetRowIds().GetNumberOfEdges(); }
  vtkIdType GetNumberOfColumns() const override { return this->LevelIds.GetNumberOfVertices(); }
  vtkIdType GetNumberOfRows() const override
  {
    vtkIdType rows = this->GetNumberOfVertices() + this->GetNumberOfEdges();
    ForShapes(typename Split::Shapes(),
      [&](auto shape)
      {
        using Shape = decltype(shape);
        rows += Shape::Centres * vtkIdType(this->GetRowIds().GetNumberOfChildren(Shape::Index));
      });
    return rows;
  }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;

private:
  const Ids& GetRowIds() const { return this->Selection ? this->Selection->Ids : this->LevelIds; }

  const typename Split::Level& Level;
  const Ids LevelIds;
  const Selected* const Selection;
};

}

#endif
