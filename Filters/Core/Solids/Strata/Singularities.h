// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Singularities.h
 * Singular simplices that follow from the mesh itself (Mathematics 7): embedded cells, material
 * interfaces, features.
 */
#ifndef SubdivisionObjects_Singularities_h
#define SubdivisionObjects_Singularities_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Solids/Strata/Strata.h"

#include <vector>

namespace subdivision
{

/// Simplices as vertex tuples of dimension + 1 ids, by dimension.
struct SimplexTuples
{
  std::vector<vtkIdType> Tuples[3];
  bool IsEmpty() const
  {
    return this->Tuples[0].empty() && this->Tuples[1].empty() && this->Tuples[2].empty();
  }
};

/// The simplex, by its place in the output order, that each edge, face or tetrahedron is; -1 for
/// those that are no cell.
template <typename Id>
Buffer<vtkIdType> FindSimplicesOf(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int dimension);

/// Lower-dimensional cells that are faces of others; `inside`: only those in the interior of a C_k
/// of higher dimension.
template <typename Id>
void DeriveEmbedded(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  bool inside, SimplexTuples& derived);

/// Faces between two tetrahedra, edges between two maximal triangles, with different values;
/// `values` has one for each simplex in output order.
template <typename Id>
void DeriveInterfaces(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const double* values, SimplexTuples& derived);

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
/// what may be rounding.
bool IsFeature(const FeatureCandidate& candidate, const Coordinates& points, double degrees);

/// Adds the flags of flagged cells: `flags` has one for each simplex in output order.
template <typename Id>
void FlagSimplices(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const unsigned char* flags, SingularSimplices& singular);

}

#endif
