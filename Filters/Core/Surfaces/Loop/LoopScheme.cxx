// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Loop/LoopScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/SectorMasks.h"
#include "Core/Surfaces/Loop/LoopRegular.h"
#include "Core/Surfaces/Loop/LoopRowsOfNext.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "Core/Surfaces/Scheme/SectorRows.h"
#include "Core/Surfaces/Scheme/SurfaceLimits.h"

#include <array>
#include <cmath>

namespace subdivision
{
namespace
{

template <typename Id>
class LoopScheme : public QuarteringScheme<Id>
{
public:
  LoopScheme(bool modifiedBoundary, LoopWeights weights)
    : QuarteringScheme<Id>([weights](const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
                             vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
        { AppendLoopRowsOfNext(level, weights, others, begin, end, rows); })
    , ModifiedBoundary(modifiedBoundary)
    , Weights(weights)
  {
  }
  bool BlendsJoints() const override { return true; }
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 9., 26., 88., 118. }; }
  double GetThirdEigenvalue(int k, double angle) const override
  {
    return GetThirdEigenvalueOfTriangles(k, angle);
  }
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override;

  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override;

private:
  void AppendVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, std::vector<Id>& ring, RowBlock<Id>& rows) const;
  void AppendVertex(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex,
    std::vector<Id>& ring, RowBlock<Id>& rows) const;
  void AppendEdge(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, Id edge,
    std::vector<Id>& ring, RowBlock<Id>& rows) const;
  void AppendBlendEdge(
    const SurfaceLevel<Id>& level, Id edge, std::vector<Id>& ring, RowBlock<Id>& rows) const;
  void AppendEdgeAtCurve(
    const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, RowBlock<Id>& rows) const;

  bool ModifiedBoundary;
  LoopWeights Weights;
};

template <typename Id>
void LoopScheme<Id>::AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  const vtkIdType vertices = level.Mesh.NumberOfVertices;
  std::vector<Id> ring;
  this->AppendVertices(level, tags, begin, std::min(end, vertices), ring, rows);
  const PolygonMesh<Id>& mesh = level.Mesh;
  const auto isOnCurve = [&tags](Id v)
  { return tags.Vertices[v] == VertexTag::Curve || tags.Vertices[v] == VertexTag::Corner; };
  for (vtkIdType row = std::max(begin, vertices); row < end; ++row)
  {
    row += rows.AddRun(LoopEdge, end - row,
      [&](vtkIdType i, Id* columns)
      {
        const Id edge = static_cast<Id>(row + i - vertices);
        columns[0] = mesh.EdgeVertices[2 * edge];
        columns[1] = mesh.EdgeVertices[2 * edge + 1];
        if (tags.Edges[edge] != EdgeTag::Smooth || isOnCurve(columns[0]) || isOnCurve(columns[1]))
        {
          return false;
        }
        const Id corner = mesh.EdgeCorners[edge];
        columns[2] = mesh.Vertices[mesh.Previous(corner)];
        columns[3] = mesh.Vertices[mesh.Previous(mesh.Twins[corner])];
        return true;
      });
    if (row < end)
    {
      this->AppendEdge(level, tags, static_cast<Id>(row - vertices), ring, rows);
      rows.EndRow();
    }
  }
}

template <typename Id>
void LoopScheme<Id>::AppendVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  vtkIdType begin, vtkIdType end, std::vector<Id>& ring, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const auto isSmooth = [&](vtkIdType v) { return tags.Vertices[v] == VertexTag::Smooth; };
  const vtkIdType firstOnEdge =
    level.VerticesBefore < 0 ? end : std::min<vtkIdType>(end, level.VerticesBefore);
  AppendLoopVertices(
    level, tags, this->Weights, begin, firstOnEdge,
    [&](const FanStep<Id>& step) { return GetNeighbour(mesh, step); },
    [&](Id vertex) { this->AppendVertex(mesh, tags, vertex, ring, rows); }, rows);
  for (vtkIdType vertex = std::max(begin, firstOnEdge); vertex < end; ++vertex)
  {
    vertex += rows.AddRun(LoopVertex, end - vertex,
      [&](vtkIdType i, Id* columns)
      {
        columns[0] = static_cast<Id>(vertex + i);
        return isSmooth(vertex + i) && FindRingOfEdgePoint(mesh, columns[0], columns + 1);
      });
    if (vertex < end)
    {
      this->AppendVertex(mesh, tags, static_cast<Id>(vertex), ring, rows);
      rows.EndRow();
    }
  }
}

/// Appends the row of a vertex that has not six neighbours around it, or is not smooth.
template <typename Id>
void LoopScheme<Id>::AppendVertex(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags,
  Id vertex, std::vector<Id>& ring, RowBlock<Id>& rows) const
{
  if (tags.Vertices[vertex] == VertexTag::Smooth)
  {
    AppendLoopVertex(
      mesh, vertex, this->Weights,
      [&](const FanStep<Id>& step) { return GetNeighbour(mesh, step); }, rows);
    return;
  }
  if (tags.Vertices[vertex] != VertexTag::Blend)
  {
    AppendCurveVertex(mesh, tags, vertex, 3. / 4., ring, rows);
    return;
  }
  CollectEdges(mesh, vertex, [](Id) { return true; }, ring);
  for (Id& member : ring)
  {
    member = mesh.GetOtherEnd(member, vertex);
  }
  AppendLoopRing(vertex, Rule::Blend, this->Weights, ring, rows);
}

/// Appends the row of an edge that is not inside the smooth surface.
template <typename Id>
void LoopScheme<Id>::AppendEdge(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, Id edge,
  std::vector<Id>& ring, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id a = mesh.EdgeVertices[2 * edge];
  const Id b = mesh.EdgeVertices[2 * edge + 1];
  if (IsSharp(tags.Edges[edge]))
  {
    rows.Add(a, 0.5);
    rows.Add(b, 0.5);
    return;
  }
  if (tags.Edges[edge] == EdgeTag::Blend)
  {
    this->AppendBlendEdge(level, edge, ring, rows);
    return;
  }
  this->AppendEdgeAtCurve(mesh, tags, edge, rows);
}

/// Appends the row of a smooth edge with one or both ends on curves or corners: the mean of the
/// masks of these ends (Mathematics 12).
template <typename Id>
void LoopScheme<Id>::AppendEdgeAtCurve(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, RowBlock<Id>& rows) const
{
  const Id corner = mesh.EdgeCorners[edge];
  double weights[2] = { 0., 0. };
  FlatPoint<Id> flats[2];
  int asking = 0;
  int flat = 0;
  for (int end = 0; end < 2; ++end)
  {
    const Id vertex = mesh.EdgeVertices[2 * edge + end];
    if (tags.Vertices[vertex] != VertexTag::Curve && tags.Vertices[vertex] != VertexTag::Corner)
    {
      continue;
    }
    const Id at = GetCornerAt(mesh, corner, vertex);
    const double angle = this->ModifiedBoundary ? FindAngleOfFace(mesh, tags, vertex, at) : 0.;
    const double gamma = angle > 0. ? GetFarEndWeight(angle) : PlainEndWeight;
    weights[end] += 0.75 - gamma;
    weights[1 - end] += gamma;
    ++asking;
    if (this->ModifiedBoundary)
    {
      flats[end] = FindFlatPoint(mesh, tags, vertex, at, edge, false);
      flat += flats[end].Flatness > 0.;
    }
  }
  double kept = 1.; // weight of the point before Flatness moves it
  for (const FlatPoint<Id>& point : flats)
  {
    kept -= point.Flatness / std::max(1, flat);
  }
  rows.Add(mesh.EdgeVertices[2 * edge], kept * weights[0] / asking);
  rows.Add(mesh.EdgeVertices[2 * edge + 1], kept * weights[1] / asking);
  rows.Add(mesh.Vertices[mesh.Previous(corner)], kept / 8.);
  rows.Add(mesh.Vertices[mesh.Previous(mesh.Twins[corner])], kept / 8.);
  for (const FlatPoint<Id>& point : flats)
  {
    if (point.Flatness > 0.)
    {
      point.Append(rows, point.Flatness / flat);
    }
  }
}

/// Appends the row of a Blend edge with its relief ring (Mathematics 6): the opposite vertices of
/// all its faces and, on the control mesh, all other common neighbours of its ends.
template <typename Id>
void LoopScheme<Id>::AppendBlendEdge(
  const SurfaceLevel<Id>& level, Id edge, std::vector<Id>& ring, RowBlock<Id>& rows) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id ends[2] = { mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] };
  ring.clear();
  if (level.Step == 0)
  {
    std::vector<Id> around[2];
    for (int i = 0; i < 2; ++i)
    {
      CollectEdges(mesh, ends[i], [](Id) { return true; }, around[i]);
      for (Id& member : around[i])
      {
        member = mesh.GetOtherEnd(member, ends[i]);
      }
      std::sort(around[i].begin(), around[i].end());
    }
    std::set_intersection(around[0].begin(), around[0].end(), around[1].begin(), around[1].end(),
      std::back_inserter(ring));
  }
  else
  {
    for (Id corner : mesh.FindSheaf(edge)->Corners)
    {
      ring.push_back(mesh.Vertices[mesh.Previous(corner)]);
    }
  }
  const Mask mask = EdgeMask(Rule::Blend, static_cast<vtkIdType>(ring.size()));
  rows.Add(ends[0], mask.Own);
  rows.Add(ends[1], mask.Own);
  for (Id member : ring)
  {
    rows.Add(member, mask.Ring);
  }
}

template <typename Id>
void LoopScheme<Id>::AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const
{
  LimitFinder<Id> finder(level, tags, *this, this->ModifiedBoundary, this->Weights);
  for (vtkIdType v = begin; v < end; ++v)
  {
    finder.Append(static_cast<Id>(v), kind, rows);
    rows.EndRow();
  }
}

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeLoopScheme(bool modifiedBoundary, LoopWeights weights)
{
  return std::make_unique<LoopScheme<Id>>(modifiedBoundary, weights);
}

SUBDIVISION_COMPILE_FUNCTION(MakeLoopScheme);

}
