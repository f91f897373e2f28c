// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridFacts.h
 * Facts about cells that the output of a mesh of cells of all types tells.
 */
#ifndef SubdivisionObjects_HybridFacts_h
#define SubdivisionObjects_HybridFacts_h

#include "Core/Cells/CellComplex.h"
#include "Core/Memory/Coordinates.h"
#include "Core/Memory/Loops.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// For each cell the dimension of the maximal cell that it is, or is a part of; the largest, if
/// several.
template <typename Id>
std::vector<unsigned char> FindMaximalDimensions(const CellComplex<Id>& complex);

/// For each cell the sign of its volume, where that of a solid in the order of CellTable is 1; 0 if
/// it is no solid, or flat but for rounding.
template <typename Id>
signed char FindOrientation(CellShape shape, const Id* corners, const Coordinates& points);
template <typename Id>
std::vector<signed char> FindOrientations(const CellList<Id>& cells, const Coordinates& points);

/// Whether each cell has another sign than its control cell; empty without signs.
template <typename Id>
Buffer<unsigned char> FindInverted(
  const CellList<Id>& cells, const std::vector<signed char>& signs, const Coordinates& points);

}

#endif
