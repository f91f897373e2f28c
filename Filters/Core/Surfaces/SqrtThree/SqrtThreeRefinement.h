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

/// Sets SurfaceLevel::HasCurves and, for even steps with fixed edges, SurfaceLevel::Places: the ids
/// of centres and of the points on fixed edges.
template <typename Id>
void CountSqrtThreePlaces(SurfaceLevel<Id>& level);

template <typename Id>
SurfaceLevel<Id> RefineSqrtThree(const SurfaceLevel<Id>& level, Depth depth);

/// The vertices of the faces of the next level, one face after the other.
template <typename Id>
void WriteSqrtThree(const SurfaceLevel<Id>& level, IdsOut ids);

/// Tags of the next level: thirds of fixed edges are sharp, and the points that cut them lie on
/// curves. Old vertices and edges keep their tags, and all else is smooth.
template <typename Id>
SurfaceTags<Id> RefineSqrtThreeTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags);

/// The order of ids after a step.
template <typename Id>
void ListSqrtThreeChildren(
  const SurfaceLevel<Id>& level, const SurfaceSegments& segments, SurfaceSegments& children);

}

#endif
