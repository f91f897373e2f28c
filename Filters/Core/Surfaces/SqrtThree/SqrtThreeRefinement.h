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

/// Base class of the scheme: all but its rows.
template <typename Id>
class SqrtThreeRefinement : public SurfaceScheme<Id>
{
public:
  bool HalvesEdges() const override { return false; }
  /// Sets SurfaceLevel::HasCurves and, for even steps with fixed edges, SurfaceLevel::Places: the
  /// ids of centres and of the points on fixed edges.
  void Prepare(SurfaceLevel<Id>& level) const override;
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return SqrtThreeTopology<Id>(level).GetNumberOfVertices();
  }
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override;
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override;
  /// Thirds of fixed edges are sharp, and the points that cut them lie on curves. Old vertices and
  /// edges keep their tags, and all else is smooth.
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override;
  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override;
  int GetCarrierPeriod() const override { return 2; }
};

}

#endif
