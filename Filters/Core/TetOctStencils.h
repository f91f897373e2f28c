// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctStencils.h
 * The operator of the tet/oct scheme (SPEC 10): linear subdivision and smoothing as one
 * row-stochastic matrix. As in Stencils.h rows come as rings, and weights follow from rules
 * (TetOctMasks.h). Vertex rows first, then edge rows, then those of octahedron centres, which are
 * the mean of six: by symmetry smoothing leaves them where they are.
 */
#ifndef SubdivisionObjects_TetOctStencils_h
#define SubdivisionObjects_TetOctStencils_h

#include "Stencils.h"
#include "TetOctComplex.h"

namespace subdivision
{

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

  vtkIdType GetNumberOfColumns() const { return this->Vertices.size(); }
  vtkIdType GetNumberOfRows() const
  {
    return this->Vertices.size() + this->Edges.size() + this->OctVertices.size() / 6;
  }
  std::size_t GetMemorySize() const;

  /// Appends columns and weights of a vertex's or edge's row, each weight times `factor`.
  void AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const;

  /// out = S in, for `components` interleaved values per vertex. Integers are rounded.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;

  /// Control vertices of dimension 3 have weights of their own.
  bool IsControlSolid(vtkIdType vertex) const
  {
    return vertex < this->NumberOfControlVertices &&
      this->Vertices[vertex].GetRule() == Rule::Solid;
  }
};

/// Takes the operator out of a level that is not refined any more; write its cells first.
template <typename Id>
TetOctStencils<Id> TakeStencils(TetOctLevel<Id>& level);

}

#endif
