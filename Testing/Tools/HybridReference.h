// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridReference.h
 * A step of the hybrid scheme by its definition, slowly: all cells are split linearly, then each
 * new point is averaged inside its stratum from centroids of the fine cells. It knows nothing of
 * Filters, so that what Core computes can be held against it.
 */
#ifndef SubdivisionObjects_HybridReference_h
#define SubdivisionObjects_HybridReference_h

#include "HybridReferenceStrata.h"

#include <map>
#include <vector>

namespace hybridtest
{

/// Weights by point.
using Row = std::map<int, double>;

struct Level
{
  Mesh Fine;
  std::vector<Row> Rows; ///< the fine points by the coarse ones
};

/// One step.
Level Refine(const Mesh& mesh);

/// The weights of the limit of a vertex, by powers of the local matrix; after one step at joints,
/// and where a pyramid has its apex there.
Row LimitRow(const Mesh& mesh, int vertex);

}

#endif
