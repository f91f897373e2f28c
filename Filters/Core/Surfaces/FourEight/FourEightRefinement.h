// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightRefinement.h
 * The split of the 4-8 scheme (FourEightScheme.h): from a level to the next.
 */
#ifndef SubdivisionObjects_FourEightRefinement_h
#define SubdivisionObjects_FourEightRefinement_h

#include "Core/Surfaces/FourEight/FourEightTopology.h"
#include "Core/Surfaces/Scheme/CentreRefinement.h"

namespace subdivision
{

/// Base class of the scheme: all but its rows.
template <typename Id>
class FourEightRefinement : public CentreScheme<Id, FourEightTopology<Id>>
{
public:
  /// Sets SurfaceLevel::Places, the running counts of FourEightTopology.h.
  void Prepare(SurfaceLevel<Id>& level) const override;
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override;
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override;
  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override;
};

}

#endif
