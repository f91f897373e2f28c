// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CatmullClarkRegular.h
 * The rows of Catmull-Clark where the surface is smooth and consists of quads.
 */
#ifndef SubdivisionObjects_CatmullClarkRegular_h
#define SubdivisionObjects_CatmullClarkRegular_h

#include "Core/Surfaces/Scheme/PrimalRows.h"

namespace subdivision
{

/// The masks of a smooth vertex of four quads, each of which has a neighbour and the vertex
/// opposite in it; of an edge between two quads, the mean of its ends and of the points of both.
inline constexpr std::array<double, 9> QuadsAtVertex{ 9. / 16., 3. / 32., 1. / 64., 3. / 32.,
  1. / 64., 3. / 32., 1. / 64., 3. / 32., 1. / 64. };
inline constexpr std::array<double, 6> QuadsAtEdge{ 3. / 8., 3. / 8., 1. / 16., 1. / 16., 1. / 16.,
  1. / 16. };

/// Appends the entries of a smooth vertex of any number of quads. Each face point is a quarter of
/// the face's four corners, and each neighbour lies in two faces.
template <typename Id, typename Members>
void AppendQuadVertex(
  Id vertex, const std::vector<FanStep<Id>>& steps, const Members& members, RowBlock<Id>& rows)
{
  const int k = static_cast<int>(steps.size());
  const double edge = 1. / (static_cast<double>(k) * k);
  const double own = static_cast<double>(k - 2) / k;
  rows.Add(vertex, own + edge * k / 4.);
  for (const FanStep<Id>& step : steps)
  {
    Id two[2];
    members(step, two);
    rows.Add(two[0], 1.5 * edge);
    rows.Add(two[1], 0.25 * edge);
  }
}

}

#endif
