// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoxSpline/Refinement.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/Scheme/ChildRowsMaker.h"
#include "Core/Solids/Scheme/Refiner.h"
#include "Core/Solids/Scheme/VertexSegments.h"

namespace subdivision
{

template <typename Id>
Level<Id> Refine(const Level<Id>& parent, Depth depth)
{
  return Refiner<BoxSplineSplit<Id>>(parent, depth).Run();
}

IdSegments ListBoxSplineVertices(int steps)
{
  return ListVertexSegments<MarkedTetShape::Shapes>(steps);
}

template class ChildRows<BoxSplineSplit<int>>;
template class ChildRows<BoxSplineSplit<long long>>;
SUBDIVISION_COMPILE_FUNCTION(Refine);

}
