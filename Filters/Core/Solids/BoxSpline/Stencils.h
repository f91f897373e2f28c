// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stencils.h
 * The operator of the box-spline scheme (Mathematics 1): the matrix that takes values at the
 * vertices of a level, coordinates or any array, to those at the vertices of the next.
 *
 * Rows are stored as rules and rings without weights, which follow from the rule and the size of
 * the ring (Masks.h). Vertex rows come first, then edge rows.
 */
#ifndef SubdivisionObjects_Stencils_h
#define SubdivisionObjects_Stencils_h

#include "Core/Operators/PointOperator.h"
#include "Core/Solids/BoxSpline/Refinement.h"

#include <vector>

namespace subdivision
{

/// Rows with explicit weights, which replace those that rules and rings give.
template <typename Id>
struct ExplicitRows
{
  std::vector<Id> Rows;
  std::vector<Id> Offsets{ 0 };
  std::vector<Id> Columns;
  std::vector<double> Weights;

  /// Passes all of them.
  void ForEachBlock(const PointOperator::User& use) const;
};

/// The masks of this scheme (Masks.h).
const RingMasks& BoxSplineMasks();

/// The stored rows of an operator, or of a level from which no operator was taken yet.
template <typename Id>
struct StoredRows
{
  const Buffer<Stratum>& Vertices;
  const Buffer<Stratum>& Edges;
  const Buffer<Id>& EdgeVertices;
  const Rings<Id>& VertexRings;
  const Rings<Id>& EdgeRings;

  vtkIdType GetNumberOfRows() const { return this->Vertices.size() + this->Edges.size(); }
  /// The rows of a range of vertices or of edges.
  RingRows<Id> OfVertices(vtkIdType begin, vtkIdType end) const
  {
    return { &BoxSplineMasks(), false, begin, end - begin, this->Vertices.data() + begin, nullptr,
      this->VertexRings.Offsets.data() + begin, this->VertexRings.Members.data() };
  }
  RingRows<Id> OfEdges(vtkIdType begin, vtkIdType end) const
  {
    return { &BoxSplineMasks(), true, this->Vertices.size() + begin, end - begin,
      this->Edges.data() + begin, this->EdgeVertices.data() + 2 * begin,
      this->EdgeRings.Offsets.data() + begin, this->EdgeRings.Members.data() };
  }
};

/// RingOperator::ForRows for the rows of this scheme.
template <typename Id>
void ForStoredRows(const StoredRows<Id>& rows, const typename RingOperator<Id>::RingsUser& use);

template <typename Id>
struct Stencils : RingOperator<Id>
{
  Buffer<Stratum> Vertices;
  Buffer<Stratum> Edges;
  Buffer<Id> EdgeVertices;
  Rings<Id> VertexRings; ///< without carriers
  Rings<Id> EdgeRings;
  ExplicitRows<Id> Explicit; ///< semi-sharp creases need them

  vtkIdType GetNumberOfColumns() const override { return this->Vertices.size(); }
  vtkIdType GetNumberOfRows() const override { return this->GetStored().GetNumberOfRows(); }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;
  void ForEachBlock(const PointOperator::User& use) const override;
  std::size_t GetMemorySize() const;

  /// Appends columns and weights of the row that the rule gives, each weight times `factor`.
  void AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const;

private:
  StoredRows<Id> GetStored() const
  {
    return { this->Vertices, this->Edges, this->EdgeVertices, this->VertexRings, this->EdgeRings };
  }
};

/// Moves the operator out of a level that is not refined any more. Write its cells first, because
/// line cells need the vertices of edges.
template <typename Id>
Stencils<Id> TakeStencils(Level<Id>& level);

}

#endif
