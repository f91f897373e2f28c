// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctStencils.h
 * The operator of the tet/oct scheme (Mathematics 10): linear subdivision and smoothing as one
 * matrix. As in Stencils.h, rows are stored as rules and rings, from which weights follow
 * (TetOctMasks.h). Vertex rows come first, then edge rows, then rows of octahedron centres. A
 * centre is the mean of six vertices; by symmetry smoothing does not move it.
 */
#ifndef SubdivisionObjects_TetOctStencils_h
#define SubdivisionObjects_TetOctStencils_h

#include "Core/Solids/BoxSpline/Stencils.h"
#include "Core/Solids/TetOct/TetOctComplex.h"

namespace subdivision
{

/// The masks of this scheme (TetOctMasks.h).
const RingMasks& TetOctMasks();

/// The stored rows of an operator, or of a level from which no operator was taken yet.
template <typename Id>
struct StoredTetOctRows
{
  const Buffer<Stratum>& Vertices;
  const Buffer<Stratum>& Edges;
  const Buffer<Id>& EdgeVertices;
  const Buffer<Id>& OctVertices;
  const Rings<Id>& VertexRings;
  const Rings<Id>& EdgeRings;
  const Buffer<Id>& TetsAtSpokes;
  vtkIdType NumberOfControlVertices;

  vtkIdType GetNumberOfRows() const
  {
    return this->Vertices.size() + this->Edges.size() + this->GetNumberOfCentres();
  }
  vtkIdType GetNumberOfCentres() const { return this->OctVertices.size() / 6; }

  /// The rows of a range of vertices, of edges, or of octahedron centres.
  RingRows<Id> OfVertices(vtkIdType begin, vtkIdType end) const
  {
    return { &TetOctMasks(), false, begin, end - begin, this->Vertices.data() + begin, nullptr,
      this->VertexRings.Offsets.data() + begin, this->VertexRings.Members.data(), false,
      this->NumberOfControlVertices - begin, this->TetsAtSpokes.data() };
  }
  RingRows<Id> OfEdges(vtkIdType begin, vtkIdType end) const
  {
    return { &TetOctMasks(), true, this->Vertices.size() + begin, end - begin,
      this->Edges.data() + begin, this->EdgeVertices.data() + 2 * begin,
      this->EdgeRings.Offsets.data() + begin, this->EdgeRings.Members.data() };
  }
  RingRows<Id> OfCentres(vtkIdType begin, vtkIdType end) const
  {
    return { &TetOctMasks(), false, this->Vertices.size() + this->Edges.size() + begin, end - begin,
      nullptr, nullptr, nullptr, this->OctVertices.data() + 6 * begin, true };
  }
  /// As RingOperator::ForRows.
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const;
};

template <typename Id>
struct TetOctStencils : RingOperator<Id>
{
  Buffer<Stratum> Vertices;
  Buffer<Stratum> Edges;
  Buffer<Id> EdgeVertices;
  Buffer<Id> OctVertices;
  Rings<Id> VertexRings; ///< without carriers
  Rings<Id> EdgeRings;
  std::shared_ptr<const Buffer<Id>> TetsAtSpokes;
  vtkIdType NumberOfControlVertices = 0;
  ExplicitRows<Id> Explicit; ///< semi-sharp creases need them

  StoredTetOctRows<Id> GetRows() const
  {
    return { this->Vertices, this->Edges, this->EdgeVertices, this->OctVertices, this->VertexRings,
      this->EdgeRings, *this->TetsAtSpokes, this->NumberOfControlVertices };
  }
  vtkIdType GetNumberOfColumns() const override { return this->Vertices.size(); }
  vtkIdType GetNumberOfRows() const override { return this->GetRows().GetNumberOfRows(); }
  void ForRows(const typename RingOperator<Id>::RingsUser& use) const override;
  void ForEachBlock(const PointOperator::User& use) const override;
  std::size_t GetMemorySize() const;

  /// Appends columns and weights of the row that rule and ring give, each weight times `factor`.
  void AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const;
};

/// Takes the operator out of a level that is not refined any more; write its cells first.
template <typename Id>
TetOctStencils<Id> TakeStencils(TetOctLevel<Id>& level);

}

#endif
