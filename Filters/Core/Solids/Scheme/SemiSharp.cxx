// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/SemiSharp.h"

#include "Core/Memory/Ids.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
std::vector<SharpRow> FindSharpRows(
  const EdgeSharpness& sharpness, int steps, int depth, const SimplicialComplex<Id>& complex)
{
  std::vector<SharpRow> edges;
  std::vector<SharpRow> ends;
  for (std::size_t e = 0; e < sharpness.size(); ++e)
  {
    const double left = sharpness[e] - steps;
    if (!(left > 0.))
    {
      continue;
    }
    // Control edge e has become the 2^depth edges from e * 2^depth on.
    const vtkIdType first = static_cast<vtkIdType>(e) << depth;
    for (vtkIdType piece = first; piece < first + (vtkIdType(1) << depth); ++piece)
    {
      edges.push_back({ complex.NumberOfVertices + piece, left });
      ends.push_back({ complex.EdgeVertices[2 * piece], left });
      ends.push_back({ complex.EdgeVertices[2 * piece + 1], left });
    }
  }
  std::stable_sort(
    ends.begin(), ends.end(), [](const SharpRow& a, const SharpRow& b) { return a.Row < b.Row; });
  std::vector<SharpRow> rows;
  for (auto end = ends.begin(); end != ends.end();)
  {
    double sum = 0.;
    const auto first = end;
    for (; end != ends.end() && end->Row == first->Row; ++end)
    {
      sum += end->Sharpness;
    }
    rows.push_back({ first->Row, sum / static_cast<double>(end - first) });
  }
  rows.insert(rows.end(), edges.begin(), edges.end());
  return rows;
}

template <typename Id>
void BlendSemiSharp(
  const std::vector<SharpRow>& rows, const Stencils<Id>& sharp, Stencils<Id>& smooth)
{
  ExplicitRows<Id> blends;
  for (const SharpRow& row : rows)
  {
    const double weight = std::min(1., row.Sharpness);
    blends.Rows.push_back(static_cast<Id>(row.Row));
    if (weight < 1.)
    {
      smooth.AppendRow(row.Row, 1. - weight, blends);
    }
    sharp.AppendRow(row.Row, weight, blends);
    blends.Offsets.push_back(static_cast<Id>(blends.Columns.size()));
  }
  smooth.Explicit = std::move(blends);
}

SUBDIVISION_COMPILE_FUNCTION(FindSharpRows);
SUBDIVISION_COMPILE_FUNCTION(BlendSemiSharp);

}
