// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Loop/LoopScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Rules/SectorMasks.h"
#include "Core/Surfaces/Loop/LoopRegular.h"
#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/SectorRows.h"
#include "Core/Surfaces/Scheme/SurfaceLimits.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace subdivision
{
namespace
{

template <typename Id>
class LoopScheme : public PrimalScheme<Id, 3>
{
public:
  LoopScheme(bool modifiedBoundary, LoopWeights weights)
    : ModifiedBoundary(modifiedBoundary)
    , Weights(weights)
  {
  }
  bool BlendsJoints() const override { return true; }
  FaceMemory GetFaceMemory() const override { return { 32., 0.5, 9., 26., 88., 118., 26., 100. }; }
  double GetThirdEigenvalue(int k, double angle) const override
  {
    return GetThirdEigenvalueOfTriangles(k, angle);
  }
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const auto isOnCurve = [&tags](Id v)
    { return tags.Vertices[v] == VertexTag::Curve || tags.Vertices[v] == VertexTag::Corner; };
    const auto findEdge = [&](vtkIdType edge, Id* columns)
    {
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
    };
    ForKindsOfRows<2>({ mesh.NumberOfVertices, mesh.GetNumberOfEdges() }, begin, end,
      [&](std::size_t kind, vtkIdType first, vtkIdType last)
      {
        kind == 0 ? this->AppendVertices(level, tags, first, last, rows)
                  : AppendRegularGroups<1>(
                      LoopEdge, first, last, findEdge, [&](vtkIdType edge)
                      { this->AppendEdge(level, tags, static_cast<Id>(edge), rows); }, rows);
      });
  }

  bool SkipsNext(const SurfaceLevel<Id>&) const override { return true; }
  void AppendRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    AppendPrimalRowsOfNext<3>(
      level, LoopVertex, LoopEdge,
      [&](Id vertex, const std::vector<FanStep<Id>>& steps, const auto& members)
      { AppendLoopVertex(vertex, this->Weights, steps, members, rows); }, others, begin, end, rows);
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    LimitFinder<Id>(level, tags, *this, this->ModifiedBoundary, this->Weights)
      .AppendRows(kind, begin, end, rows);
  }
  const double* GetSecondTangent(const double* first) const override
  {
    return LimitFinder<Id>::template GetSecondTangent<3>(first);
  }
  bool HasLimitsOfNext(const SurfaceLevel<Id>& /*level*/, bool) const override { return true; }
  void AppendLimitRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
    LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    LimitFinder<Id>::template AppendRowsOfNext<3>(
      level, others, this->Weights, kind, begin, end, rows);
  }

private:
  void AppendVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const auto members = [&mesh](const FanStep<Id>& step, Id* one)
    { *one = GetNeighbour(mesh, step); };
    std::vector<Id> edges;
    AppendPrimalVertices<3>(
      level, tags, LoopVertex, begin, end, members,
      [&mesh](Id vertex, Id* columns)
      {
        columns[0] = vertex;
        return FindRingOfEdgePoint(mesh, vertex, columns + 1);
      },
      [&](Id vertex, const std::vector<FanStep<Id>>& steps)
      {
        if (!steps.empty())
        {
          AppendLoopVertex(vertex, this->Weights, steps, members, rows);
          return;
        }
        if (tags.Vertices[vertex] != VertexTag::Blend)
        {
          AppendCurveVertex(mesh, tags, vertex, 3. / 4., edges, rows);
          return;
        }
        CollectEdges(mesh, vertex, [](Id) { return true; }, edges);
        const Mask mask =
          VertexMask(Rule::Blend, static_cast<vtkIdType>(edges.size()), this->Weights);
        rows.Add(vertex, mask.Own);
        for (const Id edge : edges)
        {
          rows.Add(mesh.GetOtherEnd(edge, vertex), mask.Ring);
        }
      },
      rows);
  }
  /// Appends the row of an edge that is not inside the smooth surface.
  void AppendEdge(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, Id edge, RowBlock<Id>& rows) const
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
      this->AppendBlendEdge(level, edge, rows);
      return;
    }
    const EdgeAtCurve<Id> rule(mesh, tags, edge, this->ModifiedBoundary,
      [](double angle)
      {
        const double far = angle > 0. ? GetFarEndWeight(angle) : PlainEndWeight;
        return std::array<double, 2>{ 0.75 - far, far };
      });
    const double kept = rule.Flat.GetKept();
    const Id corner = mesh.EdgeCorners[edge];
    rows.Add(a, kept * rule.Weights[0] / rule.Size);
    rows.Add(b, kept * rule.Weights[1] / rule.Size);
    rows.Add(mesh.Vertices[mesh.Previous(corner)], kept / 8.);
    rows.Add(mesh.Vertices[mesh.Previous(mesh.Twins[corner])], kept / 8.);
    rule.Flat.Append(rows);
  }
  /// Appends the row of a Blend edge with its relief ring (Mathematics 6): the opposite vertices of
  /// all its faces and, on the control mesh, all other common neighbours of its ends.
  void AppendBlendEdge(const SurfaceLevel<Id>& level, Id edge, RowBlock<Id>& rows) const
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const Id ends[2] = { mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] };
    std::vector<Id> ring;
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

  bool ModifiedBoundary;
  LoopWeights Weights;
};

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeLoopScheme(bool modifiedBoundary, LoopWeights weights)
{
  return std::make_unique<LoopScheme<Id>>(modifiedBoundary, weights);
}

SUBDIVISION_COMPILE_FUNCTION(MakeLoopScheme);

}
