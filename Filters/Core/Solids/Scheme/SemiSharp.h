// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SemiSharp.h
 * Rows of semi-sharp creases: blends of the smooth and the sharp rows (Mathematics 5).
 *
 * The weight of an edge's sharp row is min(1, remaining sharpness of the edge). The sharp row of a
 * vertex has all edges as creases that are still sharp, and its weight is min(1, mean of their
 * remaining sharpness).
 */
#ifndef SubdivisionObjects_SemiSharp_h
#define SubdivisionObjects_SemiSharp_h

#include "Core/Rules/Sharpness.h"
#include "Core/Solids/Scheme/Stencils.h"

#include <vector>

namespace subdivision
{

struct SharpRow
{
  vtkIdType Row;
  double Sharpness; ///< what remains of it; of the row of a vertex the mean of its sharp edges
};

/**
 * Finds the rows that are blends: those of vertices, and then those of edges. `sharpness` has one
 * value for each control edge. Since it was given `steps` steps have been made, so that value -
 * steps remains. `depth` is the number of steps since the control mesh: a control edge has become
 * 2^depth edges of `complex`.
 */
template <typename Id>
std::vector<SharpRow> FindSharpRows(
  const EdgeSharpness& sharpness, int steps, int depth, const SimplicialComplex<Id>& complex);

/// Replaces these rows of `smooth` by blends with rows of `sharp`, which is the same operator with
/// all edges singular that are still sharp.
template <typename Id>
void BlendSemiSharp(
  const std::vector<SharpRow>& rows, const Stencils<Id>& sharp, Stencils<Id>& smooth);

}

#endif
