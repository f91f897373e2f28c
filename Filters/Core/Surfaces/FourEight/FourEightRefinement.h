// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightRefinement.h
 * The split of the 4-8 scheme (FourEightScheme.h): from a level to the next.
 */
#ifndef SubdivisionObjects_FourEightRefinement_h
#define SubdivisionObjects_FourEightRefinement_h

#include "Core/Surfaces/FourEight/FourEightTopology.h"

namespace subdivision
{

/// Counts where the children of a level come.
template <typename Id>
void CountFourEightPlaces(SurfaceLevel<Id>& level);

template <typename Id>
SurfaceLevel<Id> RefineFourEight(const SurfaceLevel<Id>& level, Depth depth);

/// Fixed edges, their halves and their middles lie on the curve; everything else new is smooth.
template <typename Id>
SurfaceTags<Id> RefineFourEightTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags);

}

#endif
