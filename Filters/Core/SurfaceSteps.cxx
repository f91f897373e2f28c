// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSteps.h"

#include "DualPlaces.h"
#include "SurfaceRings.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// One row for each that occurs, with the mean of what it was given; ascending.
template <typename WeightedRow>
void MergeRows(std::vector<WeightedRow>& given, std::vector<WeightedRow>& rows)
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

}

template <typename Id>
SurfaceSteps<Id>::SurfaceSteps(SurfaceLevel<Id>&& control,
  std::shared_ptr<const SurfaceScheme<Id>> scheme, int steps, bool lastIsWhole,
  const std::function<bool(double)>& stop)
  : Scheme(std::move(scheme))
{
  this->Levels.reserve(steps + 1);
  this->Levels.push_back(std::move(control));
  const SurfaceTags<Id>& given = this->Levels[0].Tags;
  this->GivenEdges = Buffer<EdgeTag>(given.Edges.size());
  this->GivenVertices = Buffer<VertexTag>(given.Vertices.size());
  std::copy(given.Edges.begin(), given.Edges.end(), this->GivenEdges.begin());
  std::copy(given.Vertices.begin(), given.Vertices.end(), this->GivenVertices.begin());
  this->Scheme->RestrictTags(this->Levels[0]);
  for (int step = 0; step < steps && !(stop && stop(0.5 * step / steps)); ++step)
  {
    const bool whole = step + 1 < steps || lastIsWhole;
    this->Scheme->Prepare(this->Levels.back());
    this->Levels.push_back(
      this->Scheme->Refine(this->Levels.back(), whole ? Depth::ForRefinement : Depth::ForOutput));
  }
  if (lastIsWhole)
  {
    this->Scheme->Prepare(this->Levels.back());
  }
}

template <typename Id>
bool SurfaceSteps<Id>::ReplaceSectors(const SurfaceTags<Id>& control)
{
  const bool same = this->GivenEdges.size() == control.Edges.size() &&
    this->GivenVertices.size() == control.Vertices.size() &&
    this->Levels[0].Tags.Sectors.size() == control.Sectors.size() &&
    std::equal(control.Edges.begin(), control.Edges.end(), this->GivenEdges.begin()) &&
    std::equal(control.Vertices.begin(), control.Vertices.end(), this->GivenVertices.begin());
  for (SurfaceLevel<Id>& level : this->Levels)
  {
    std::vector<Sector<Id>>& sectors = level.Tags.Sectors; // in the same order on all levels
    for (std::size_t s = 0; same && s < sectors.size(); ++s)
    {
      sectors[s].Angle = control.Sectors[s].Angle;
      sectors[s].Flatness = control.Sectors[s].Flatness;
    }
  }
  return same;
}

template <typename Id>
void SurfaceSteps<Id>::SetSharpness(const EdgeSharpness& sharpness,
  const std::function<SurfaceTags<Id>(const std::vector<bool>& sharpEdges)>& classify)
{
  this->SharpSteps.clear();
  for (int step = 0; step < this->GetNumberOfSteps() && IsSharpAfter(sharpness, step); ++step)
  {
    std::vector<bool> sharp(sharpness.size());
    std::transform(
      sharpness.begin(), sharpness.end(), sharp.begin(), [step](double s) { return s > step; });
    this->SharpSteps.push_back(this->MakeSharpStep(step, sharpness, classify(sharp)));
  }
}

/// Smooth edges between which and a curve other rules work: blended as their ends on it are.
template <typename Id>
void SurfaceSteps<Id>::AddSmoothEdges(int step, const SurfaceTags<Id>& tags,
  const std::vector<WeightedRow>& vertices, std::vector<WeightedRow>& rows) const
{
  const PolygonMesh<Id>& mesh = this->Levels[step].Mesh;
  std::vector<WeightedRow> edges;
  std::vector<Id> around;
  for (const WeightedRow& vertex : vertices)
  {
    CollectEdges(
      mesh, static_cast<Id>(vertex.Row), [&tags](Id e) { return tags.Edges[e] == EdgeTag::Smooth; },
      around);
    for (Id edge : around)
    {
      edges.push_back({ mesh.NumberOfVertices + edge, vertex.Sharpness });
    }
  }
  MergeRows(edges, rows);
}

template <typename Id>
typename SurfaceSteps<Id>::SharpStep SurfaceSteps<Id>::MakeSharpStep(
  int step, const EdgeSharpness& sharpness, SurfaceTags<Id>&& tags) const
{
  SharpStep sharp;
  sharp.Tags = std::move(tags);
  for (Sector<Id>& sector : sharp.Tags.Sectors)
  {
    if (this->Levels[0].Tags.Vertices[sector.Vertex] != VertexTag::Corner)
    {
      sector.Flatness = 0.; // a corner for some levels only
    }
  }
  for (int level = 0; level < step; ++level)
  {
    sharp.Tags = this->Scheme->RefineTags(this->Levels[level], sharp.Tags);
  }
  const PolygonMesh<Id>& mesh = this->Levels[step].Mesh;
  std::vector<WeightedRow> ends;
  std::vector<WeightedRow> edges;
  for (std::size_t e = 0; e < sharpness.size(); ++e)
  {
    const double left = sharpness[e] - step;
    if (!(left > 0.))
    {
      continue;
    }
    // The pieces of control edge e are the edges e 2^step and following.
    const vtkIdType first = static_cast<vtkIdType>(e) << step;
    for (vtkIdType piece = first; piece < first + (vtkIdType(1) << step); ++piece)
    {
      edges.push_back({ mesh.NumberOfVertices + piece, left });
      const Id ids[2] = { mesh.EdgeVertices[2 * piece], mesh.EdgeVertices[2 * piece + 1] };
      ends.push_back({ ids[0], left });
      ends.push_back({ ids[1], left });
    }
  }
  MergeRows(ends, sharp.Rows);
  this->AddSmoothEdges(step, sharp.Tags, sharp.Rows, edges);
  std::sort(edges.begin(), edges.end(),
    [](const WeightedRow& a, const WeightedRow& b) { return b.Row > a.Row; });
  sharp.Rows.insert(sharp.Rows.end(), edges.begin(), edges.end());
  return sharp;
}

/// Rows [begin, end), where some edges are still sharp: the smooth rule's and the sharp rule's.
template <typename Id>
void SurfaceSteps<Id>::AppendBlended(
  int step, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const SurfaceLevel<Id>& level = this->Levels[step];
  const SharpStep& sharp = this->SharpSteps[step];
  auto at = std::lower_bound(sharp.Rows.begin(), sharp.Rows.end(), begin,
    [](const WeightedRow& row, vtkIdType r) { return r > row.Row; });
  RowBlock<Id> one;
  auto add = [&](const SurfaceTags<Id>& tags, vtkIdType row, double factor)
  {
    one.Clear();
    this->Scheme->AppendRows(level, tags, row, row + 1, one);
    for (std::size_t k = 0; k < one.GetNumberOfEntries(); ++k)
    {
      rows.Add(one.GetColumns()[k], factor * one.GetWeights()[k]);
    }
  };
  for (vtkIdType row = begin; row < end;)
  {
    const vtkIdType next = at == sharp.Rows.end() ? end : std::min<vtkIdType>(end, at->Row);
    if (next > row)
    {
      this->Scheme->AppendRows(level, level.Tags, row, next, rows);
      row = next;
      continue;
    }
    const double weight = std::min(1., at->Sharpness);
    if (weight < 1.)
    {
      add(level.Tags, row, 1. - weight);
    }
    add(sharp.Tags, row, weight);
    rows.EndRow();
    ++row;
    ++at;
  }
}

template <typename Id>
BlockOperator<Id> SurfaceSteps<Id>::GetStep(int step) const
{
  const SurfaceLevel<Id>& level = this->Levels[step];
  const vtkIdType rows = this->Scheme->GetNumberOfRows(level);
  if (step < static_cast<int>(this->SharpSteps.size()))
  {
    return BlockOperator<Id>(level.Mesh.NumberOfVertices, rows,
      [this, step](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
      { this->AppendBlended(step, begin, end, block); });
  }
  return BlockOperator<Id>(level.Mesh.NumberOfVertices, rows,
    [this, &level](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    { this->Scheme->AppendRows(level, level.Tags, begin, end, block); });
}

template <typename Id>
BlockOperator<Id> SurfaceSteps<Id>::GetLimit(LimitKind kind) const
{
  const SurfaceLevel<Id>& level = this->Levels.back();
  const vtkIdType vertices = level.Mesh.NumberOfVertices;
  return BlockOperator<Id>(vertices, vertices,
    [this, &level, kind](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    { this->Scheme->AppendLimitRows(level, level.Tags, kind, begin, end, block); });
}

template <typename Id>
std::size_t SurfaceSteps<Id>::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const SurfaceLevel<Id>& level : this->Levels)
  {
    bytes += level.Mesh.GetMemorySize() + level.Tags.Edges.GetMemorySize() +
      level.Tags.Vertices.GetMemorySize() + level.Lines.GetMemorySize() +
      level.Places.GetMemorySize() + (level.Dual ? level.Dual->GetMemorySize() : 0);
  }
  return bytes;
}

template class SurfaceSteps<int>;
template class SurfaceSteps<long long>;

}
