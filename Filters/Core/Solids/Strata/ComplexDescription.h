// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComplexDescription.h
 * A report on a complex for the user: for each vertex, edge and face the columns of the table of
 * Mathematics 3, whether it is singular, and its rule (Mathematics 4); and counts of the whole
 * complex.
 */
#ifndef SubdivisionObjects_ComplexDescription_h
#define SubdivisionObjects_ComplexDescription_h

#include "Core/Solids/Strata/Strata.h"

namespace subdivision
{

/// One vertex, edge or face.
struct SimplexFacts
{
  int Valence;                      ///< vertices in the link; of a face: tetrahedra
  unsigned char ManifoldDimensions; ///< bit k - 1: lies in C_k
  unsigned char NonManifoldType;    ///< 0 to 3
  signed char RuleDimension;        ///< 0 to 3, 4 blended; -1 for faces
  bool Boundary;                    ///< in some C_k it lies on the boundary and is manifold
  bool Singular; ///< itself flagged or derived, and not only a face of such a simplex

  /// False for a simplex that lies in the interior of exactly one C_k, is not singular and follows
  /// the rule of dimension k (faces have no rule).
  bool IsSpecial() const;
};

template <typename Id>
struct ComplexDescription
{
  /// The used vertices, the edges and the faces, each list in the lexicographic order of sorted
  /// vertices.
  Buffer<Id> Order[3];
  /// Of each vertex (used or not), edge, face, by its number in the complex.
  Buffer<SimplexFacts> Facts[3];
  vtkIdType Counts[4] = { 0, 0, 0, 0 };     ///< simplices by dimension
  vtkIdType Components[4] = { 0, 0, 0, 0 }; ///< connected components of C_0 to C_3
};

/// `strata` belong to the complex; their rings are not read.
template <typename Id>
ComplexDescription<Id> DescribeComplex(const SimplicialComplex<Id>& complex,
  const Strata<Id>& strata, const SingularSimplices& singular);

}

#endif
