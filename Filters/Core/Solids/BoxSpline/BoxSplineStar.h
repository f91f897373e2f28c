// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxSplineStar.h
 * The box-spline scheme for LevelStar (LevelStar.h): its masks, and that no ring has members inside
 * solids.
 */
#ifndef SubdivisionObjects_BoxSplineStar_h
#define SubdivisionObjects_BoxSplineStar_h

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"

namespace subdivision
{

template <typename Id>
class BoxSplineStar
{
public:
  explicit BoxSplineStar(const Level<Id>& level)
    : Masks(BoxSplineMasks(level.Strata.Weights))
  {
  }

  const RingMasks& GetMasks() const { return this->Masks; }
  vtkIdType CountSolids(Id, Rule, vtkIdType) const { return 0; }
  vtkIdType CountFaces(Rule, vtkIdType ringSize) const { return ringSize; }
  Id GetOppositeEnd(Id, Id vertex) const { return vertex; }
  template <typename Add>
  void ForEdgesInSolid(Id, Id, const Add&) const
  {
  }
  Id GetEdgeBeyond(Id, Id, Id) const { return -1; }
  bool HasSpokes(Id, Rule) const { return false; }

private:
  const RingMasks& Masks;
};

}

#endif
