// SPDX-License-Identifier: BSD-3-Clause
#include "SharpRows.h"

#include "SurfaceRings.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
SharpRows<Id>::SharpRows(
  const PolygonMesh<Id>& mesh, SurfaceTags<Id>&& tags, const std::vector<SharpEdge<Id>>& edges)
  : Tags(std::move(tags))
{
  std::vector<WeightedRow> ends;
  std::vector<WeightedRow> rows;
  for (const SharpEdge<Id>& edge : edges)
  {
    const vtkIdType e = edge.Edge;
    rows.push_back({ mesh.NumberOfVertices + e, edge.Left });
    ends.push_back({ mesh.EdgeVertices[2 * e], edge.Left });
    ends.push_back({ mesh.EdgeVertices[2 * e + 1], edge.Left });
  }
  Merge(ends, this->Rows);
  this->AddSmoothEdges(mesh, rows);
  std::sort(rows.begin(), rows.end(),
    [](const WeightedRow& a, const WeightedRow& b) { return b.Row > a.Row; });
  this->Rows.insert(this->Rows.end(), rows.begin(), rows.end());
}

/// One row for each that occurs, with the mean of what it was given; ascending.
template <typename Id>
void SharpRows<Id>::Merge(std::vector<WeightedRow>& given, std::vector<WeightedRow>& rows)
{
  std::stable_sort(given.begin(), given.end(),
    [](const WeightedRow& a, const WeightedRow& b) { return b.Row > a.Row; });
  for (auto at = given.begin(); at != given.end();)
  {
    double sum = 0.;
    const auto first = at;
    for (; at != given.end() && at->Row == first->Row; ++at)
    {
      sum += at->Sharpness;
    }
    rows.push_back({ first->Row, sum / static_cast<double>(at - first) });
  }
}

/// Smooth edges between which and a curve other rules work: blended as their ends on it are.
template <typename Id>
void SharpRows<Id>::AddSmoothEdges(
  const PolygonMesh<Id>& mesh, std::vector<WeightedRow>& rows) const
{
  std::vector<WeightedRow> edges;
  std::vector<Id> around;
  for (const WeightedRow& vertex : this->Rows)
  {
    CollectEdges(
      mesh, static_cast<Id>(vertex.Row),
      [this](Id e) { return this->Tags.Edges[e] == EdgeTag::Smooth; }, around);
    for (Id edge : around)
    {
      edges.push_back({ mesh.NumberOfVertices + edge, vertex.Sharpness });
    }
  }
  Merge(edges, rows);
}

template <typename Id>
void SharpRows<Id>::Append(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  auto at = std::lower_bound(this->Rows.begin(), this->Rows.end(), begin,
    [](const WeightedRow& row, vtkIdType r) { return r > row.Row; });
  RowBlock<Id> one;
  auto add = [&](const SurfaceTags<Id>& tags, vtkIdType row, double factor)
  {
    one.Clear();
    scheme.AppendRows(level, tags, row, row + 1, one);
    for (std::size_t k = 0; k < one.GetNumberOfEntries(); ++k)
    {
      rows.Add(one.GetColumns()[k], factor * one.GetWeights()[k]);
    }
  };
  for (vtkIdType row = begin; row < end;)
  {
    const vtkIdType next = at == this->Rows.end() ? end : std::min<vtkIdType>(end, at->Row);
    if (next > row)
    {
      scheme.AppendRows(level, level.Tags, row, next, rows);
      row = next;
      continue;
    }
    const double weight = std::min(1., at->Sharpness);
    if (weight < 1.)
    {
      add(level.Tags, row, 1. - weight);
    }
    add(this->Tags, row, weight);
    rows.EndRow();
    ++row;
    ++at;
  }
}

template class SharpRows<int>;
template class SharpRows<long long>;

}
