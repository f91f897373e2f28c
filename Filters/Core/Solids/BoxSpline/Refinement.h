// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Refinement.h
 * One uniform step of the box-spline scheme (Mathematics 2): the step of Refiner.h with the solids
 * of BoxSplineSplit.h.
 */
#ifndef SubdivisionObjects_Refinement_h
#define SubdivisionObjects_Refinement_h

#include "Core/Solids/Scheme/Level.h"

namespace subdivision
{

template <typename Id>
Level<Id> Refine(const Level<Id>& parent, Depth depth);

/// The order in which levels number their vertices (VertexSegments.h).
IdSegments ListBoxSplineVertices(int steps);

}

#endif
