// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComposedRows.h
 * Turns rows over the vertices of a level into rows over the vertices of the level before it.
 */
#ifndef SubdivisionObjects_ComposedRows_h
#define SubdivisionObjects_ComposedRows_h

#include "Core/Operators/SparseRows.h"
#include "Core/Solids/Scheme/Stencils.h"

namespace subdivision
{

/// The product rows * step. Only rows of `step` that columns of `rows` name are made.
template <typename Id>
SparseRows<int> Compose(const SparseRows<int>& rows, const Stencils<Id>& step);

}

#endif
