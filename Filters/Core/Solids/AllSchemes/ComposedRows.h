// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComposedRows.h
 * Turns rows over the vertices of a level into rows over the vertices of the level before it.
 */
#ifndef SubdivisionObjects_ComposedRows_h
#define SubdivisionObjects_ComposedRows_h

#include "Core/Operators/SparseRows.h"

namespace subdivision
{

/// The product rows * step. `step` is the Operator of a volume scheme; of its rows only those that
/// columns of `rows` name are made.
template <typename Operator>
SparseRows<int> Compose(const SparseRows<int>& rows, const Operator& step);

}

#endif
