// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeRefinement.h
 * The split of the sqrt(3) scheme (SqrtThreeScheme.h): from a level to the next.
 */
#ifndef SubdivisionObjects_SqrtThreeRefinement_h
#define SubdivisionObjects_SqrtThreeRefinement_h

#include "Core/Surfaces/Scheme/CentreRefinement.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeTopology.h"

namespace subdivision
{

/// Base class of the scheme: all but its rows.
template <typename Id>
class SqrtThreeRefinement : public CentreScheme<Id, SqrtThreeTopology<Id>>
{
public:
  /// Sets SurfaceLevel::HasCurves and, for even steps with fixed edges, SurfaceLevel::Places: the
  /// ids of centres and of the points on fixed edges.
  void Prepare(SurfaceLevel<Id>& level) const override;
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override;
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override;
  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override;
};

}

#endif
