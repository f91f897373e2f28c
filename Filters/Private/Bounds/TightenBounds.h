// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TightenBounds.h
 * Makes bounds smaller by further steps, where they are not near the truth.
 */
#ifndef SubdivisionObjects_TightenBounds_h
#define SubdivisionObjects_TightenBounds_h

#include "Private/Bounds/Deviations.h"
#include "Private/Bounds/PartsAsCells.h"

#include <vector>

namespace subdivision
{

/// How many steps are looked at beyond the three of all cells, by the dimension of a cell: so that
/// 512 parts of it are the most, or 729 where edges are cut into thirds.
constexpr int MostFurtherSteps[4] = { 0, 8, 4, 3 };
constexpr int MostFurtherStepsInThirds[4] = { 0, 5, 3, 0 };

/**
 * Looks at the parts of cells whose pieces have bounds that are not near the cell's Least, one step
 * deeper each time, until they are, or until MostFurtherSteps. Each step leaves about a quarter (a
 * ninth) of the excess of a bound. A cell whose bound would not come near even so is left alone.
 * `limits` are values on the limit at the first points; empty if nobody knows them. Returns false
 * if `split` does not go on.
 */
bool TightenBounds(const SteppedPieces& pieces, const SplitCells& split,
  const BoundedValues& values, const Buffer<double>& limits, std::vector<CellBound>& bounds);

}

#endif
