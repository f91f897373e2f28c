// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpSectors.h
 * Edges whose rule depends on a sector (SectorEdges.h) at a crease that is still sharp for some
 * steps: their rows are blends, too (Mathematics 5).
 */
#ifndef SubdivisionObjects_SharpSectors_h
#define SubdivisionObjects_SharpSectors_h

#include "Core/Solids/Scheme/SemiSharp.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// The mean of the sharpness of the ends of an edge that have some: sharpness(end).
template <typename Id, typename Sharpness>
double GetMeanOfEnds(const Id* ends, const Sharpness& sharpness)
{
  const double values[2] = { sharpness(ends[0]), sharpness(ends[1]) };
  const double sum = values[0] + values[1];
  return values[0] > 0. && values[1] > 0. ? sum / 2. : sum;
}

/// Adds rows to the blends of a step: of edges of sectors with an end on a crease that is still
/// sharp. `smooth`, `sharp`: the rows of such edges by the smooth and by the sharp rules; `rows`,
/// as both, ascend, before and after.
template <typename Id>
void AddSharpSectors(const std::vector<Id>& smooth, const std::vector<Id>& sharp,
  const Buffer<Id>& edgeVertices, vtkIdType vertices, std::vector<SharpRow>& rows);

/// Explicit rows with blends of a smooth and a sharp row each instead of some of `smooth`; `rows`
/// ascend. appendSmooth(row, factor, rows) and appendSharp append a row times a factor.
template <typename Id, typename AppendSmooth, typename AppendSharp>
ExplicitRows<Id> BlendRows(const std::vector<SharpRow>& rows, const ExplicitRows<Id>& smooth,
  const AppendSmooth& appendSmooth, const AppendSharp& appendSharp)
{
  ExplicitRows<Id> blends;
  const auto append = [&](Id row, double weight)
  {
    blends.Rows.push_back(row);
    if (weight < 1.)
    {
      appendSmooth(row, 1. - weight, blends);
    }
    if (weight > 0.)
    {
      appendSharp(row, weight, blends);
    }
    blends.Offsets.push_back(static_cast<Id>(blends.Columns.size()));
  };
  auto own = smooth.Rows.begin();
  for (const SharpRow& row : rows)
  {
    for (; own != smooth.Rows.end() && *own < row.Row; ++own)
    {
      append(*own, 0.);
    }
    own += own != smooth.Rows.end() && *own == row.Row ? 1 : 0;
    append(static_cast<Id>(row.Row), std::min(1., row.Sharpness));
  }
  std::for_each(own, smooth.Rows.end(), [&](Id row) { append(row, 0.); });
  return blends;
}

}

#endif
