// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxSplineStar.h
 * What LevelStar (LimitStencils.cxx) needs to know of the box-spline scheme: its masks, and that no
 * ring has members inside solids.
 */
#ifndef SubdivisionObjects_BoxSplineStar_h
#define SubdivisionObjects_BoxSplineStar_h

#include "Core/Rules/Masks.h"
#include "Core/Solids/Scheme/Level.h"

namespace subdivision
{

template <typename Id>
class BoxSplineStar
{
public:
  explicit BoxSplineStar(const Level<Id>&) {}

  static PartedMask GetVertexMask(Rule rule, vtkIdType ringSize)
  {
    return MakeParted(ringSize > 0 ? VertexMask(rule, ringSize) : Mask{ 1., 0. }, ringSize);
  }
  static PartedMask GetEdgeMask(Rule rule, vtkIdType ringSize)
  {
    return MakeParted(EdgeMask(rule, ringSize), ringSize);
  }
  vtkIdType CountSolids(Id, Rule, vtkIdType) const { return 0; }
  vtkIdType CountFaces(Rule, vtkIdType ringSize) const { return ringSize; }
  Id GetOppositeEnd(Id, Id vertex) const { return vertex; }
  template <typename Add>
  void ForEdgesInSolid(Id, Id, const Add&) const
  {
  }
  Id GetEdgeBeyond(Id, Id, Id) const { return -1; }
  bool HasSpokes(Id, Rule) const { return false; }
  template <typename Add>
  static void WeighSpokes(const int*, const int*, int, const Add&)
  {
  }
};

}

#endif
