// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComposedRows.h
 * Rows over the points of a level, as rows over those of the level above.
 */
#ifndef SubdivisionObjects_ComposedRows_h
#define SubdivisionObjects_ComposedRows_h

#include "Core/Operators/SparseRows.h"
#include "Core/Solids/TetOct/TetOctStencils.h"

namespace subdivision
{

/// rows * step. Of the step, one of Stencils or TetOctStencils, only the rows that are named are
/// ever written down.
template <typename Operator>
SparseRows<int> Compose(const SparseRows<int>& rows, const Operator& step);

}

#endif
