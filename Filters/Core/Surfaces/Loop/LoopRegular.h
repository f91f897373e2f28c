// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopRegular.h
 * Loop's rows where the surface is smooth, with six neighbours or others.
 */
#ifndef SubdivisionObjects_LoopRegular_h
#define SubdivisionObjects_LoopRegular_h

#include "Core/Rules/Masks.h"
#include "Core/Surfaces/Scheme/PrimalRows.h"

namespace subdivision
{

/// The masks of a smooth vertex with six neighbours, and of a smooth edge inside.
inline constexpr std::array<double, 7> LoopVertex{ 5. / 8., 3. / (8. * 6.), 3. / (8. * 6.),
  3. / (8. * 6.), 3. / (8. * 6.), 3. / (8. * 6.), 3. / (8. * 6.) };
inline constexpr std::array<double, 4> LoopEdge{ 3. / 8., 3. / 8., 1. / 8., 1. / 8. };

/// Appends the entries of a smooth vertex with any number of neighbours.
template <typename Id, typename Members>
void AppendLoopVertex(Id vertex, LoopWeights weights, const std::vector<FanStep<Id>>& steps,
  const Members& members, RowBlock<Id>& rows)
{
  const Mask mask = VertexMask(Rule::Surface, static_cast<vtkIdType>(steps.size()), weights);
  rows.Add(vertex, mask.Own);
  for (const FanStep<Id>& step : steps)
  {
    Id member;
    members(step, &member);
    rows.Add(member, mask.Ring);
  }
}

}

#endif
