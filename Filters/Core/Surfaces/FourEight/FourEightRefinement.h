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

/// Sets SurfaceLevel::Places, the running counts of FourEightTopology.h.
template <typename Id>
void CountFourEightPlaces(SurfaceLevel<Id>& level);

template <typename Id>
SurfaceLevel<Id> RefineFourEight(const SurfaceLevel<Id>& level, Depth depth);

/// The vertices of the faces of the next level, one face after the other.
template <typename Id>
void WriteFourEight(const SurfaceLevel<Id>& level, IdsOut ids);

/// Tags of the next level: fixed edges, or their halves, are sharp, and their midpoints lie on
/// curves. Old vertices keep their tags, and all else is smooth. Without fixed edges the next level
/// need not store its edges, and then has no tags of them.
template <typename Id>
SurfaceTags<Id> RefineFourEightTags(
  const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, bool hasEdges = true);

/// The order of ids after a step.
template <typename Id>
void ListFourEightChildren(
  const SurfaceLevel<Id>& level, const SurfaceSegments& segments, SurfaceSegments& children);

}

#endif
