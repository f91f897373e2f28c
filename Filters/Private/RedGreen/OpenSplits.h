// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpenSplits.h
 * Whether cells may come apart where red-green refinement splits them.
 */
#ifndef SubdivisionObjects_OpenSplits_h
#define SubdivisionObjects_OpenSplits_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/RedGreen/RedGreen.h"

namespace subdivision
{

/// Whether a point of the input lies on a line, a triangle or a face of one tetrahedron that is
/// split, and is none of its corners: refinement ends there although another cell may go on. Takes
/// n log n steps for n cells that are split, and looks at all points if some of their faces are on
/// the border.
template <typename Id>
bool HasOpenSplits(const RedGreen<Id>& state, const Coordinates& points);

}

#endif
