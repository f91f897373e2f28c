// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridLimits.h
 * Limit rows of a level in which every cell keeps its type (Mathematics 8, 15).
 *
 * All that the rows at a vertex read lies in the cells at it, and the child at the vertex keeps the
 * order of its parent. So the rows of the new points at the vertex are a matrix A over the corners
 * of these cells, and w A = w. Where a pyramid has its apex at the vertex it becomes an octahedron,
 * and some rules hold in the first step only: then A is that of the next level, and the limit is
 * w (S P). Equal cells with equal rules at a vertex are solved once.
 */
#ifndef SubdivisionObjects_HybridLimits_h
#define SubdivisionObjects_HybridLimits_h

#include "Core/Operators/BlockOperator.h"
#include "Core/Operators/Interpolation.h"
#include "Core/Solids/Hybrid/HybridLevel.h"

#include <algorithm>

namespace subdivision
{

/// The limits of all vertices of a level, which must live as long. Rows are made when they are
/// used.
template <typename Id>
BlockOperator<Id> MakeLimitOperator(const HybridLevel<Id>& level);

/// Makes such rows one by one. For one thread; both arguments must live as long.
template <typename Id>
typename HybridRows<Id>::AddRow StartLimits(
  const HybridLevel<Id>& level, const HybridRows<Id>& rows);

/// What a solver may expect of these limits (Mathematics 15): a lattice of hexahedra has the
/// eigenvalue 1/27, one of wedges 1/12, quads have 1/9. Without more products than usual hexahedra
/// would all be solved for directly.
template <typename Id>
InterpolationLimits GetInterpolationLimits(const CellList<Id>& cells)
{
  InterpolationLimits limits;
  const bool hasColumns = std::any_of(cells.Shapes.begin(), cells.Shapes.end(),
    [](CellShape shape) { return shape == CellShape::Hex || shape == CellShape::Wedge; });
  limits.LeastEigenvalue = hasColumns ? 1. / 30. : 1. / 10.;
  limits.MostProducts = hasColumns ? 80 : limits.MostProducts;
  return limits;
}

}

#endif
