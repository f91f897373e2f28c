// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedCounts.h
 * Counts and components of a complex of which several partitions have parts.
 */
#ifndef SubdivisionObjects_SharedCounts_h
#define SubdivisionObjects_SharedCounts_h

#include "Core/Solids/Strata/ComplexDescription.h"
#include "Private/Partitions/OtherPartitions.h"

#include <vector>

namespace subdivision
{

struct ComplexNumbers
{
  vtkIdType Counts[4] = { 0, 0, 0, 0 };     ///< simplices by dimension
  vtkIdType Components[4] = { 0, 0, 0, 0 }; ///< connected components of C_0 to C_3
};

/// The simplices of a complex that are a partition's own.
struct OwnSimplices
{
  /// Of each vertex, edge, face and tetrahedron: 1 if the first cell that it lies on is own. So
  /// each simplex counts in one partition.
  Buffer<unsigned char> Flags[4];
  /// Vertices of own cells, and among them the vertices at which other partitions have cells:
  /// ascending.
  std::vector<vtkIdType> Shared;
};

/**
 * The numbers of the whole complex. Each partition finds the components of its own edges;
 * components of two partitions that share a vertex are one. Whoever keeps the vertex learns which
 * these are, and tells the first partition: two exchanges, 24 bytes for each component at a shared
 * vertex, and 40 for each two components that meet at the border of two partitions.
 */
template <typename Id>
ComplexNumbers CountTogether(const SimplicialComplex<Id>& complex,
  const ComplexDescription<Id>& description, const OwnSimplices& own, OtherPartitions& others);

}

#endif
