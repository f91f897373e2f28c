// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SemiSharp.h
 * Creases that are sharp for some levels: rows between the smooth and the sharp rule.
 *
 * An edge of sharpness s follows the sharp rule for s levels, the last, if s is no whole number, in
 * part; then the smooth rule. A vertex follows the sharp rule with all edges that are still sharp,
 * with the weight min(1, mean of their sharpness).
 */
#ifndef SubdivisionObjects_SemiSharp_h
#define SubdivisionObjects_SemiSharp_h

#include "Core/Rules/Sharpness.h"
#include "Core/Solids/BoxSpline/Stencils.h"

namespace subdivision
{

/**
 * Replaces rows of `smooth`, the operator `steps` steps on from where `sharpness` holds, by blends
 * with those of `sharp`, the same operator with all edges singular that are then still sharp.
 * The operator is one of Stencils or TetOctStencils.
 * `depth`: number of steps since the control mesh, to which the edges of `sharpness` belong.
 */
template <typename Operator>
void BlendSemiSharp(
  const EdgeSharpness& sharpness, int steps, int depth, const Operator& sharp, Operator& smooth);

}

#endif
