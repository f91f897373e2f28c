// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComplexDescription.h
 * Everything there is to say about the vertices, edges and faces of a complex: the table of
 * Mathematics 3, what is singular, the rules of Mathematics 4, and numbers of the whole.
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
  bool Boundary;                    ///< lies on the boundary of a C_k, as a manifold
  bool Singular;                    ///< flagged or derived itself

  /// False inside one C_k where nothing is singular and the rule is that of dimension k.
  bool IsSpecial() const;
};

template <typename Id>
struct ComplexDescription
{
  /// The vertices that simplices have, edges, faces; lexicographic by sorted vertices.
  Buffer<Id> Order[3];
  /// Of each vertex (used or not), edge, face, by its number in the complex.
  Buffer<SimplexFacts> Facts[3];
  vtkIdType Counts[4] = { 0, 0, 0, 0 };     ///< simplices by dimension
  vtkIdType Components[4] = { 0, 0, 0, 0 }; ///< connected components of C_0 to C_3

  vtkIdType GetEulerCharacteristic() const
  {
    return this->Counts[0] - this->Counts[1] + this->Counts[2] - this->Counts[3];
  }
};

/// `strata` are those of the complex; its rings are not read.
template <typename Id>
ComplexDescription<Id> DescribeComplex(const SimplicialComplex<Id>& complex,
  const Strata<Id>& strata, const SingularSimplices& singular);

extern template ComplexDescription<int> DescribeComplex(
  const SimplicialComplex<int>&, const Strata<int>&, const SingularSimplices&);
extern template ComplexDescription<long long> DescribeComplex(
  const SimplicialComplex<long long>&, const Strata<long long>&, const SingularSimplices&);

}

#endif
