// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Restriction.h
 * A part of a level as a level of its own, to be refined where detail is needed.
 */
#ifndef SubdivisionObjects_Restriction_h
#define SubdivisionObjects_Restriction_h

#include "Core/Memory/Selection.h"
#include "Core/Solids/Limits/LimitStencils.h"

namespace subdivision
{

/// Chooses the part: all simplices at some vertices, and the faces of these simplices. Simplices
/// keep their order.
template <typename Id>
class Restriction
{
public:
  /// `complex` was made with Depth::ForRefinement; `at`: whether all that lies at a vertex is kept.
  Restriction(const SimplicialComplex<Id>& complex, const Buffer<unsigned char>& at);

  /// The part's cells; none counts as a cell of the output.
  SimplicialComplex<Id> Restrict(const SimplicialComplex<Id>& complex) const;
  /// Rings lose members that are not kept. So rings at the border of the part, and rows made from
  /// them, lack entries.
  Strata<Id> Restrict(const Strata<Id>& strata) const;
  SemiSharpStages<Id> Restrict(const SemiSharpStages<Id>& creases) const;

  /// The number in the part of each vertex of the level (-1 if it is not kept), and the inverse.
  const Buffer<Id>& GetNewVertices() const { return this->Vertices.New; }
  const Buffer<Id>& GetOldVertices() const { return this->Vertices.Old; }
  /// The edges, faces and tetrahedra of the level that the part has.
  const Buffer<Id>& GetOldEdges() const { return this->Edges.Old; }
  const Buffer<Id>& GetOldFaces() const { return this->Faces.Old; }
  const Buffer<Id>& GetOldTets() const { return this->Tets.Old; }

private:
  static Rings<Id> Restrict(const Rings<Id>& rings, const Selection<Id>& owners,
    const Selection<Id>& carriers, const Selection<Id>& members);

  Selection<Id> Vertices;
  Selection<Id> Edges;
  Selection<Id> Faces;
  Selection<Id> Tets;
};

}

#endif
