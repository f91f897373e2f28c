// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeRefinement.h
 * The split of the sqrt(3) scheme (SqrtThreeScheme.h): from a level to the next.
 */
#ifndef SubdivisionObjects_SqrtThreeRefinement_h
#define SubdivisionObjects_SqrtThreeRefinement_h

#include "Core/Surfaces/SqrtThree/SqrtThreeTopology.h"

namespace subdivision
{

/// Even steps cut fixed edges: counts where the centres and thirds come.
template <typename Id>
void CountSqrtThreePlaces(SurfaceLevel<Id>& level);

template <typename Id>
SurfaceLevel<Id> RefineSqrtThree(const SurfaceLevel<Id>& level, Depth depth);

/// The vertices of the faces of the next level, one face after the other.
template <typename Id, typename Out>
void WriteSqrtThree(const SurfaceLevel<Id>& level, Out* ids);

/// Pieces of fixed edges, and what cuts them, lie on the curve; everything else new is smooth.
template <typename Id>
SurfaceTags<Id> RefineSqrtThreeTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags);

}

#endif
