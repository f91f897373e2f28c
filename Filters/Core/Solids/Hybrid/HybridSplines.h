// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridSplines.h
 * Cells over which the limit is a polynomial: lines on smooth curves, quads and triangles with
 * regular surroundings on smooth surfaces, and hexahedra inside of lattices (Mathematics 8, 15).
 */
#ifndef SubdivisionObjects_HybridSplines_h
#define SubdivisionObjects_HybridSplines_h

#include "Core/Cells/CellFrames.h"
#include "Core/Operators/PlaceSum.h"
#include "Core/Solids/Hybrid/HybridLevel.h"

#include <array>
#include <cstddef>
#include <vector>

namespace subdivision
{

/// The control points of the polynomial over a cell; none, if there is none.
template <typename Id>
std::vector<Id> FindSpline(const HybridLevel<Id>& level, vtkIdType cell);

/// The weights of these `size` points at a place, by the shares of the corners of the cell.
/// `along`: how the place changes with each parameter. Hexahedra have no second derivatives.
std::vector<PartWeights> WeighSpline(CellShape shape, std::size_t size, const CornerShares& shares,
  const std::array<FramePoint, 3>& along);

}

#endif
