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

/// Base class of the scheme: all but its rows.
template <typename Id>
class FourEightRefinement : public SurfaceScheme<Id>
{
public:
  bool HalvesEdges() const override { return false; }
  /// Sets SurfaceLevel::Places, the running counts of FourEightTopology.h.
  void Prepare(SurfaceLevel<Id>& level) const override;
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return FourEightTopology<Id>(level).GetNumberOfVertices();
  }
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override;
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override;
  /// Fixed edges, or their halves, are sharp, and their midpoints lie on curves. Old vertices keep
  /// their tags, and all else is smooth.
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override;
  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override;
  int GetCarrierPeriod() const override { return 2; }
};

}

#endif
