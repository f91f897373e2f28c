// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Stencils.h
 * The one operator (SPEC 1): a row-stochastic matrix that takes the values at the vertices of a
 * level to those of the next, whatever the values are.
 *
 * Rows come as rings: which weights a row has follows from its rule and the size of its ring
 * (Masks.h), so only vertex ids are stored. Vertex rows first, then edge rows. Each row is summed
 * in double, in the order of the ring, and stored in the type of the array.
 */
#ifndef SubdivisionObjects_Stencils_h
#define SubdivisionObjects_Stencils_h

#include "Refinement.h"

namespace subdivision
{

template <typename Id>
struct Stencils
{
  Buffer<Stratum> Vertices;
  Buffer<Stratum> Edges;
  Buffer<Id> EdgeVertices;
  Rings<Id> VertexRings; ///< without carriers
  Rings<Id> EdgeRings;

  vtkIdType GetNumberOfColumns() const { return this->Vertices.size(); }
  vtkIdType GetNumberOfRows() const { return this->Vertices.size() + this->Edges.size(); }
  std::size_t GetMemorySize() const;

  /// out = S in, for `components` interleaved values per vertex. Integers are rounded.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;
};

/// Takes the operator out of a level that is not refined any more. What writes cells stays.
template <typename Id>
Stencils<Id> TakeStencils(Level<Id>& level);

}

#endif
