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

/// A view of consecutive rows, all of vertices, of edges, or of octahedron centres.
template <typename Id>
struct TetOctRows : StencilRows<Id>
{
  /// If true, each ring is the six vertices of an octahedron, and Strata and Offsets are null.
  bool OfCentres = false;
  /// For rows of vertices: the first rows up to this number belong to control vertices. Their
  /// weights depend on the number of tetrahedra at each edge, which TetsAtSpokes has for each
  /// member of their rings.
  vtkIdType NumberOfControlVertices = 0;
  const Id* TetsAtSpokes = nullptr;

  Row<Id> GetRing(vtkIdType i) const
  {
    return this->OfCentres ? Row<Id>{ this->Members + 6 * i, this->Members + 6 * (i + 1) }
                           : StencilRows<Id>::GetRing(i);
  }
  bool IsControlSolid(vtkIdType i) const
  {
    return i < this->NumberOfControlVertices && this->Strata[i].GetRule() == Rule::Solid;
  }
};

/// out = rows times in, as of other rows.
template <typename Id, typename T>
void SumRows(const TetOctRows<Id>& rows, const T* in, T* out, int components);

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
  TetOctRows<Id> OfVertices(vtkIdType begin, vtkIdType end) const
  {
    return { StencilRows<Id>{ false, begin, end - begin, this->Vertices.data() + begin, nullptr,
               this->VertexRings.Offsets.data() + begin, this->VertexRings.Members.data() },
      false, this->NumberOfControlVertices - begin, this->TetsAtSpokes.data() };
  }
  TetOctRows<Id> OfEdges(vtkIdType begin, vtkIdType end) const
  {
    return { StencilRows<Id>{ true, this->Vertices.size() + begin, end - begin,
      this->Edges.data() + begin, this->EdgeVertices.data() + 2 * begin,
      this->EdgeRings.Offsets.data() + begin, this->EdgeRings.Members.data() } };
  }
  TetOctRows<Id> OfCentres(vtkIdType begin, vtkIdType end) const
  {
    return { StencilRows<Id>{ false, this->Vertices.size() + this->Edges.size() + begin,
               end - begin, nullptr, nullptr, nullptr, this->OctVertices.data() + 6 * begin },
      true };
  }
};

template <typename Id>
struct TetOctStencils
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
  vtkIdType GetNumberOfColumns() const { return this->Vertices.size(); }
  vtkIdType GetNumberOfRows() const { return this->GetRows().GetNumberOfRows(); }
  std::size_t GetMemorySize() const;

  /// Appends columns and weights of the row that rule and ring give, each weight times `factor`.
  void AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const;

  /// out = S in, for `components` interleaved values per vertex. Integers are rounded.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;
};

/// Takes the operator out of a level that is not refined any more; write its cells first.
template <typename Id>
TetOctStencils<Id> TakeStencils(TetOctLevel<Id>& level);

}

#endif
