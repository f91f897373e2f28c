// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Refinement.h
 * One uniform step of the box-spline scheme (Mathematics 2). All ids of children follow by
 * arithmetic, and children inherit strata.
 *
 * With V vertices, E edges, F faces and T tetrahedra on a level, the next one has
 *  - vertices: v stays v; the point of edge e is V + e;
 *  - edges: 2e, 2e + 1 the halves of e; 2E + 3f + i inside face f near its vertex i;
 *    2E + 3F + t the diagonal of tetrahedron t;
 *  - faces: 4f + i near vertex i of f, 4f + 3 its middle; 4F + 8t + i inside tetrahedron t
 *    (tetrahedron::InteriorFaces);
 *  - tetrahedra: 8t + i (tetrahedron::Children).
 * Every iteration writes a range of its own, so the result does not depend on threads.
 */
#ifndef SubdivisionObjects_Refinement_h
#define SubdivisionObjects_Refinement_h

#include "Core/Solids/Scheme/Level.h"

namespace subdivision
{

template <typename Id>
Level<Id> Refine(const Level<Id>& parent, Depth depth);

/// The edges of an EqualCells tetrahedron or triangle in its own vertex order, taken from its twin.
template <typename Id>
void GetEdgesOfEqualTet(const SimplicialComplex<Id>& complex, vtkIdType index, Id edges[6]);
template <typename Id>
void GetEdgesOfEqualTriangle(const SimplicialComplex<Id>& complex, vtkIdType index, Id edges[3]);

/// Makes the children of equal lines and triangles, and finds the twins of these children. Both
/// volume schemes use it, as it does not depend on how solids are split.
template <typename Id>
void RefineEqualLinesAndTriangles(
  const SimplicialComplex<Id>& parent, SimplicialComplex<Id>& child);

#define SUBDIVISION_REFINEMENT_TEMPLATES(EXTERN, Id)                                               \
  EXTERN template Level<Id> Refine(const Level<Id>&, Depth);                                       \
  EXTERN template void RefineEqualLinesAndTriangles(                                               \
    const SimplicialComplex<Id>&, SimplicialComplex<Id>&);                                         \
  EXTERN template void GetEdgesOfEqualTet(const SimplicialComplex<Id>&, vtkIdType, Id[6]);         \
  EXTERN template void GetEdgesOfEqualTriangle(const SimplicialComplex<Id>&, vtkIdType, Id[3])
SUBDIVISION_REFINEMENT_TEMPLATES(extern, int);
SUBDIVISION_REFINEMENT_TEMPLATES(extern, long long);

}

#endif
