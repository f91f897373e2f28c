// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SharpLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <cmath>
#include <memory>

namespace subdivision
{
template <typename Id>
std::vector<Id> CollectNear(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges)
{
  return CollectWithNeighbours(mesh, CollectWithNeighbours(mesh, CollectEnds(mesh, edges)));
}

namespace
{

/// Refines the surroundings of some vertices step by step, and takes the limit rows of each vertex
/// as soon as no sharp edge is near it.
template <typename Id>
class Descent
{
public:
  using RowEntries = typename SharpLimits<Id>::RowEntries;

  Descent(const SurfaceLevel<Id>& level, const SurfaceScheme<Id>& scheme,
    const std::vector<Id>& vertices, const SharpCreases<Id>& creases,
    std::vector<RowEntries>* limits)
    : Scheme(scheme)
    , Vertices(vertices)
    , Steps(creases.Stages.back().Until)
    , Limits(limits)
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      this->Owners.push_back(i);
    }
    this->Crop(level, creases);
    const std::vector<Id>& inside = this->Patch->GetVertices();
    const BlockOperator<Id> start(level.Mesh.NumberOfVertices,
      static_cast<vtkIdType>(inside.size()),
      [&inside](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          rows.Add(inside[row], 1.);
          rows.EndRow();
        }
      });
    this->Rows = start.Store();
  }

  void Run()
  {
    for (int step = 0; step < this->Steps; ++step)
    {
      this->FinishSmooth(step);
      if (step == SharpLimits<Id>::MostStepsOfTangents)
      {
        this->KeepTangents(step);
      }
      this->Step();
    }
    this->FinishSmooth(this->Steps);
  }

private:
  void Step()
  {
    SharpCreases<Id> creases;
    const SurfaceLevel<Id> next = this->Patch->Refine(creases);
    const std::unique_ptr<SharpPatch<Id>> before = std::move(this->Patch);
    this->Crop(next, creases);
    const std::vector<Id>& inside = this->Patch->GetVertices();
    const BlockOperator<Id> rows(before->GetLevel().Mesh.NumberOfVertices,
      static_cast<vtkIdType>(inside.size()),
      [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          before->AppendRow(inside[row], block);
        }
      });
    this->Rows = Multiply(rows.Store(), this->Rows);
  }

  void Keep(LimitKind kind, double factor)
  {
    const BlockOperator<Id> limit(this->Patch->GetLevel().Mesh.NumberOfVertices,
      static_cast<vtkIdType>(this->Vertices.size()),
      [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->Patch->AppendLimitRow(this->Vertices[i], kind, rows);
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

  /// Takes the limit rows of vertices that have no sharp edge near them any more.
  void FinishSmooth(int step)
  {
    const std::vector<Id> near =
      CollectNear(this->Patch->GetLevel().Mesh, this->Patch->GetSharpEdges());
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

  /// Takes the patch of a level around Vertices, and renumbers these.
  void Crop(const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases)
  {
    this->Patch = std::make_unique<SharpPatch<Id>>(this->Scheme, level, creases, this->Vertices);
    for (Id& vertex : this->Vertices)
    {
      vertex = this->Patch->FindVertex(vertex);
    }
  }

  const SurfaceScheme<Id>& Scheme;
  std::vector<Id> Vertices;        ///< of the patch
  std::vector<std::size_t> Owners; ///< the row of Limits that each vertex belongs to
  const int Steps;                 ///< after which no crease is sharp
  std::unique_ptr<SharpPatch<Id>> Patch;
  SparseRows<Id> Rows;             ///< the operator from vertices of the level to the patch
  std::vector<RowEntries>* Limits; ///< of each kind
};

}

template <typename Id>
SharpLimits<Id>::SharpLimits(
  const SurfaceLevel<Id>& level, const SurfaceScheme<Id>& scheme, const SharpCreases<Id>& creases)
{
  this->Vertices = CollectNear(level.Mesh, creases.Edges);
  for (auto& rows : this->Rows)
  {
    rows.resize(this->Vertices.size());
  }
  Descent<Id>(level, scheme, this->Vertices, creases, this->Rows).Run();
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
SUBDIVISION_COMPILE_FUNCTION(CollectNear);

}
