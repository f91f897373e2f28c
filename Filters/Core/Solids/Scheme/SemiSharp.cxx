// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/SemiSharp.h"

#include "Core/Memory/Ids.h"

#include <algorithm>

namespace subdivision
{
namespace
{

struct SharpRow
{
  vtkIdType Row;
  double Sharpness;
};

template <typename Id>
void AppendBlend(const Stencils<Id>& sharp, const Stencils<Id>& smooth, vtkIdType row,
  double sharpness, ExplicitRows<Id>& rows)
{
  const double weight = std::min(1., sharpness);
  rows.Rows.push_back(static_cast<Id>(row));
  if (weight < 1.)
  {
    smooth.AppendRow(row, 1. - weight, rows);
  }
  sharp.AppendRow(row, weight, rows);
  rows.Offsets.push_back(static_cast<Id>(rows.Columns.size()));
}

}

template <typename Id>
void BlendSemiSharp(const EdgeSharpness& sharpness, int steps, int depth, const Stencils<Id>& sharp,
  Stencils<Id>& smooth)
{
  ExplicitRows<Id> rows;
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
      edges.push_back({ smooth.Vertices.size() + piece, left });
      ends.push_back({ smooth.EdgeVertices[2 * piece], left });
      ends.push_back({ smooth.EdgeVertices[2 * piece + 1], left });
    }
  }
  std::stable_sort(
    ends.begin(), ends.end(), [](const SharpRow& a, const SharpRow& b) { return a.Row < b.Row; });
  for (auto end = ends.begin(); end != ends.end();)
  {
    double sum = 0.;
    const auto first = end;
    for (; end != ends.end() && end->Row == first->Row; ++end)
    {
      sum += end->Sharpness;
    }
    AppendBlend(sharp, smooth, first->Row, sum / static_cast<double>(end - first), rows);
  }
  for (const SharpRow& edge : edges)
  {
    AppendBlend(sharp, smooth, edge.Row, edge.Sharpness, rows);
  }
  smooth.Explicit = std::move(rows);
}

SUBDIVISION_COMPILE_FUNCTION(BlendSemiSharp);

}
