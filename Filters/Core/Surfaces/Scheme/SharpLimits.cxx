// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SharpLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Surfaces/Scheme/SurfacePatch.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <cmath>
#include <memory>

namespace subdivision
{
namespace
{

/// Collects the vertices whose limits depend on sharp edges: the ends of these edges, their
/// neighbours, because the rules of edges and faces there depend on them, and the neighbours of
/// these, because of tangents.
template <typename Id>
std::vector<Id> CollectNear(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges)
{
  std::vector<Id> ends;
  for (const SharpEdge<Id>& edge : edges)
  {
    ends.push_back(mesh.EdgeVertices[2 * edge.Edge]);
    ends.push_back(mesh.EdgeVertices[2 * edge.Edge + 1]);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return CollectWithNeighbours(mesh, CollectWithNeighbours(mesh, ends));
}

/// Refines the surroundings of some vertices step by step, and takes the limit rows of each vertex
/// as soon as no sharp edge is near it.
template <typename Id>
class Descent
{
public:
  using RowEntries = typename SharpLimits<Id>::RowEntries;

  Descent(const SurfaceLevel<Id>& level, const SurfaceScheme<Id>& scheme,
    const std::vector<Id>& vertices, const std::vector<SharpEdge<Id>>& edges,
    std::vector<SharpTags<Id>>&& stages, std::vector<RowEntries>* limits)
    : Scheme(scheme)
    , Vertices(vertices)
    , Edges(edges)
    , Stages(std::move(stages))
    , Limits(limits)
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      this->Owners.push_back(i);
    }
    this->Crop(level);
    const BlockOperator<Id> start(level.Mesh.NumberOfVertices, this->Patch->Vertices.size(),
      [this](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          rows.Add(this->Patch->Vertices[row], 1.);
          rows.EndRow();
        }
      });
    this->Rows = start.Store();
  }

  void Run()
  {
    const int steps = this->Stages.back().Until;
    for (int step = 0; step < steps; ++step)
    {
      this->FinishSmooth(step);
      if (step == SharpLimits<Id>::MostStepsOfTangents)
      {
        this->KeepTangents(step);
      }
      this->Step(step);
    }
    this->Edges.clear();
    this->FinishSmooth(steps);
  }

private:
  void Step(int step)
  {
    if (this->Stages.size() > 1 && this->Stages.front().Until <= step)
    {
      this->Stages.erase(this->Stages.begin());
    }
    const SurfaceLevel<Id> level = std::move(this->Patch->Level);
    const SharpTagPair<Id>& tags = this->Stages.front().Tags;
    const SharpRows<Id> sharp(
      level, { this->CopyTags(tags.Whole), this->CopyTags(tags.All) }, this->Edges);
    SurfaceLevel<Id> next = this->Scheme.Refine(level, Depth::ForRefinement);
    for (SharpTags<Id>& stage : this->Stages)
    {
      stage.Tags = { this->Scheme.RefineTags(level, stage.Tags.Whole),
        this->Scheme.RefineTags(level, stage.Tags.All) };
    }
    std::vector<SharpEdge<Id>> halves;
    for (const SharpEdge<Id>& edge : this->Edges)
    {
      for (Id half = 2 * edge.Edge; half < 2 * edge.Edge + 2 && edge.Left > 1.; ++half)
      {
        halves.push_back({ half, edge.Left - 1. });
      }
    }
    this->Edges = std::move(halves);
    this->Crop(next);
    const BlockOperator<Id> rows(level.Mesh.NumberOfVertices, this->Patch->Vertices.size(),
      [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          const vtkIdType made = this->Patch->Vertices[row];
          sharp.Append(this->Scheme, level, made, made + 1, block);
        }
      });
    this->Rows = Multiply(rows.Store(), this->Rows);
  }

  void Keep(LimitKind kind, double factor)
  {
    const SurfaceLevel<Id>& level = this->Patch->Level;
    const BlockOperator<Id> limit(level.Mesh.NumberOfVertices, this->Vertices.size(),
      [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id vertex = this->Vertices[i];
          this->Scheme.AppendLimitRows(level, level.Tags, kind, vertex, vertex + 1, rows);
        }
      });
    const SparseRows<Id> rows = Multiply(limit.Store(), this->Rows);
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      RowEntries& row = this->Limits[static_cast<int>(kind)][this->Owners[i]];
      for (vtkIdType k = rows.Offsets[i]; k < rows.Offsets[i + 1]; ++k)
      {
        row.push_back({ rows.Columns[k], factor * rows.Weights[k] });
      }
    }
  }

  /// Scales tangents by 2^step, because each step halves them.
  void KeepTangents(int step)
  {
    this->Keep(LimitKind::Tangent1, std::ldexp(1., step));
    this->Keep(LimitKind::Tangent2, std::ldexp(1., step));
  }

  /// Takes the limit rows of those vertices that have no sharp edge near them any more.
  void FinishSmooth(int step)
  {
    const PolygonMesh<Id>& mesh = this->Patch->Level.Mesh;
    const std::vector<Id> near = CollectNear(mesh, this->Edges);
    std::vector<Id> rest[2];
    std::vector<std::size_t> owners[2];
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      const Id vertex = this->Vertices[i];
      const int stays = std::binary_search(near.begin(), near.end(), vertex);
      rest[stays].push_back(vertex);
      owners[stays].push_back(this->Owners[i]);
    }
    this->Vertices = std::move(rest[0]);
    this->Owners = std::move(owners[0]);
    this->Keep(LimitKind::Position, 1.);
    if (step <= SharpLimits<Id>::MostStepsOfTangents)
    {
      this->KeepTangents(step);
    }
    this->Vertices = std::move(rest[1]);
    this->Owners = std::move(owners[1]);
  }

  static SurfaceTags<Id> CopyTags(const SurfaceTags<Id>& tags)
  {
    SurfaceTags<Id> copy;
    copy.Edges = Buffer<EdgeTag>(tags.Edges.size());
    copy.Vertices = Buffer<VertexTag>(tags.Vertices.size());
    std::copy(tags.Edges.begin(), tags.Edges.end(), copy.Edges.begin());
    std::copy(tags.Vertices.begin(), tags.Vertices.end(), copy.Vertices.begin());
    copy.Sectors = tags.Sectors;
    return copy;
  }

  /// Replaces a level by its patch around Vertices, and renumbers Vertices, Stages and Edges.
  void Crop(const SurfaceLevel<Id>& level)
  {
    this->Patch = std::make_unique<SurfacePatch<Id>>(level, this->Vertices);
    for (Id& vertex : this->Vertices)
    {
      vertex = SurfacePatch<Id>::Find(this->Patch->Vertices, vertex);
    }
    for (SharpTags<Id>& stage : this->Stages)
    {
      stage.Tags = { this->Patch->CropTags(level, stage.Tags.Whole),
        this->Patch->CropTags(level, stage.Tags.All) };
    }
    std::vector<SharpEdge<Id>> kept;
    for (const SharpEdge<Id>& edge : this->Edges)
    {
      const Id own = SurfacePatch<Id>::Find(this->Patch->Edges, edge.Edge);
      if (own >= 0)
      {
        kept.push_back({ own, edge.Left });
      }
    }
    this->Edges = std::move(kept);
    this->Scheme.Prepare(this->Patch->Level);
  }

  const SurfaceScheme<Id>& Scheme;
  std::vector<Id> Vertices;        ///< of the patch
  std::vector<std::size_t> Owners; ///< the row of Limits that each vertex belongs to
  std::vector<SharpEdge<Id>> Edges;
  std::vector<SharpTags<Id>> Stages;
  std::unique_ptr<SurfacePatch<Id>> Patch;
  SparseRows<Id> Rows;             ///< the operator from the level's vertices to those of the patch
  std::vector<RowEntries>* Limits; ///< of each kind
};

}

template <typename Id>
SharpLimits<Id>::SharpLimits(const SurfaceLevel<Id>& level, const SurfaceScheme<Id>& scheme,
  const std::vector<SharpEdge<Id>>& edges, std::vector<SharpTags<Id>> stages)
{
  this->Vertices = CollectNear(level.Mesh, edges);
  for (auto& rows : this->Rows)
  {
    rows.resize(this->Vertices.size());
  }
  Descent<Id>(level, scheme, this->Vertices, edges, std::move(stages), this->Rows).Run();
}

template <typename Id>
void SharpLimits<Id>::Append(vtkIdType row, LimitKind kind, RowBlock<Id>& rows) const
{
  for (const auto& entry : this->Rows[static_cast<int>(kind)][row])
  {
    rows.Add(entry.first, entry.second);
  }
  rows.EndRow();
}

SUBDIVISION_COMPILE(class SharpLimits);

}
