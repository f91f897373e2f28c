// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LinearScheme.h
 * The linear scheme as a SolidScheme: it splits as the box-spline scheme does and smooths nothing.
 * Old vertices stay, new ones are midpoints, and so each level is its own limit.
 */
#ifndef SubdivisionObjects_SolidLinearScheme_h
#define SubdivisionObjects_SolidLinearScheme_h

#include "Core/Solids/BoxSpline/BoxSplineScheme.h"

namespace subdivision
{

/// Strata and rings are the same as of the box spline: they name simplices, but have no weights.
template <typename Id>
struct LinearLevel : Level<Id>
{
};

const RingMasks& LinearMasks();

template <typename Id>
SolidRows<Id> GetSolidRows(const LinearLevel<Id>&)
{
  return { &LinearMasks() };
}
template <typename Id>
void TakeSolidRows(LinearLevel<Id>&, Stencils<Id>& stencils)
{
  stencils.Masks = &LinearMasks();
}

template <typename IdType>
struct LinearSplit : BoxSplineSplit<IdType>
{
  using Level = LinearLevel<IdType>;
};

template <typename Id>
LinearLevel<Id> Refine(const LinearLevel<Id>& parent, Depth depth)
{
  return { Refine(static_cast<const Level<Id>&>(parent), depth) };
}

template <typename Id>
struct LinearStar : BoxSplineStar<Id>
{
  using BoxSplineStar<Id>::BoxSplineStar;
  const RingMasks& GetMasks() const { return LinearMasks(); }
};

template <typename IdType>
struct LinearScheme : BoxSplineScheme<IdType>
{
  using Id = IdType;
  using Level = LinearLevel<Id>;
  using ChildRows = subdivision::ChildRows<LinearSplit<Id>>;
  using Star = LinearStar<Id>;

  static constexpr SchemeTraits Traits = { 3, true, false, BoxSplineScheme<Id>::RefineCounts,
    BoxSplineScheme<Id>::CountMoreIds, ListBoxSplineVertices, 0, 0, false };

  static Level Start(subdivision::Level<Id>&& control) { return { std::move(control) }; }
};

template <typename Id>
struct SchemeOfLevel<LinearLevel<Id>>
{
  using Type = LinearScheme<Id>;
};

}

#endif
