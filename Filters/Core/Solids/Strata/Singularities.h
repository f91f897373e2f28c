// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Singularities.h
 * Derives singular simplices from the mesh (Mathematics 7): embedded cells, material interfaces,
 * features.
 */
#ifndef SubdivisionObjects_Singularities_h
#define SubdivisionObjects_Singularities_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Solids/Strata/Strata.h"

#include <vector>

namespace subdivision
{

/// Vertices, edges and triangles as vertex ids: Tuples[d] has d + 1 ids for each simplex of
/// dimension d.
struct SimplexTuples
{
  std::vector<vtkIdType> Tuples[3];
  bool IsEmpty() const
  {
    return this->Tuples[0].empty() && this->Tuples[1].empty() && this->Tuples[2].empty();
  }
};

/// The simplices with tuples after them.
SimplexList AddTuples(const SimplexList& simplices, const SimplexTuples& tuples);
/// Sorts the tuples of a dimension by their vertices.
void SortTuples(SimplexTuples& tuples, int dimension);

/// For each vertex, edge, face or tetrahedron the position in output order of the cell that it is,
/// or -1 if it is no cell. Followers are not looked at.
template <typename Id>
Buffer<vtkIdType> FindSimplicesOf(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int dimension);

/// Derives singular simplices from embedded cells, which are faces of other cells. `inside`: only
/// from cells that lie in the interior of one C_k and in no other.
template <typename Id>
void DeriveEmbedded(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  bool inside, SimplexTuples& derived);

/// Derives singular simplices from material interfaces: faces of exactly two tetrahedra, and edges
/// of exactly two triangles, both maximal, that have different values. `values` has one for each
/// simplex in output order. Leaves out faces for which `leftOut` is true, which has a value for
/// each or is empty.
template <typename Id>
void DeriveInterfaces(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const int* values, const std::vector<bool>& leftOut, SimplexTuples& derived);

/// An edge between exactly two triangles of a surface, and the vertices opposite to it.
struct FeatureCandidate
{
  vtkIdType Ends[2];
  vtkIdType Opposite[2];
};

/// Edges between two boundary triangles of C_3, or two triangles of C_2.
template <typename Id>
std::vector<FeatureCandidate> FindFeatureCandidates(const SimplicialComplex<Id>& complex);

/// Whether the angle between the two triangles' planes (0 = flat) exceeds `degrees`, by more than
/// rounding.
bool IsFeature(const FeatureCandidate& candidate, const Coordinates& points, double degrees);

/// Adds the flags of flagged cells: `flags` has one for each simplex in output order.
template <typename Id>
void FlagSimplices(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const unsigned char* flags, SingularSimplices& singular);

}

#endif
