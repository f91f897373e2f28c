// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridNumbers.h
 * Numbers of points in the whole mesh, of which this is a part whose cells keep their types.
 */
#ifndef SubdivisionObjects_HybridNumbers_h
#define SubdivisionObjects_HybridNumbers_h

#include "Core/Cells/CellComplex.h"
#include "Private/Partitions/SharedNumbers.h"

#include <vector>

namespace subdivision
{

/// Numbers the points that a step adds: the middles of edges, then of quads, by the numbers of
/// their corners, then of solids, by their input cell and which of its centres they are. `sources`:
/// the cell of the input of each cell; `places`: PlaceCells. Six exchanges.
template <typename Id>
void NumberNewPoints(const CellComplex<Id>& complex, const std::vector<vtkIdType>& sources,
  const std::vector<vtkIdType>& places, OtherPartitions& others, WholeIds& points);

}

#endif
