// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/BlockOperator.h"

namespace subdivision
{
namespace
{

/// Whether two faces have the edge of a corner, each in its own direction.
template <typename Id>
bool IsRegularCorner(const PolygonMesh<Id>& mesh, vtkIdType corner)
{
  const Id twin = mesh.Twins[corner];
  return twin >= 0 && mesh.Vertices[twin] != mesh.Vertices[corner];
}

template <typename Id>
bool IsRegularEdge(const SurfaceLevel<Id>& level, vtkIdType edge)
{
  return level.Tags.Edges[edge] == EdgeTag::Smooth &&
    IsRegularCorner(level.Mesh, level.Mesh.EdgeCorners[edge]);
}

}

template <typename Id>
std::vector<Id> FindIrregularVertices(const SurfaceLevel<Id>& level)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const auto isSmooth = [&level](vtkIdType v)
  { return level.Tags.Vertices[v] == VertexTag::Smooth; };
  // Edges that are not stored are smooth, and each corner asks for its own.
  const bool hasEdges = !mesh.EdgeCorners.empty();
  const vtkIdType sides = hasEdges ? mesh.GetNumberOfEdges() : mesh.GetNumberOfCorners();
  const auto isRegular = [&level, hasEdges](vtkIdType side)
  { return hasEdges ? IsRegularEdge(level, side) : IsRegularCorner(level.Mesh, side); };
  std::vector<Id> vertices;
  if (AreAll(mesh.NumberOfVertices, isSmooth) && AreAll(sides, isRegular))
  {
    return vertices;
  }
  std::vector<char> flags(static_cast<std::size_t>(mesh.NumberOfVertices));
  ForEach(mesh.NumberOfVertices, [&](vtkIdType v) { flags[v] = !isSmooth(v); });
  ForEachInTurn(sides,
    [&](vtkIdType side)
    {
      if (!isRegular(side))
      {
        flags[hasEdges ? mesh.EdgeVertices[2 * side] : mesh.Vertices[side]] = 1;
        flags[hasEdges ? mesh.EdgeVertices[2 * side + 1]
                       : mesh.Vertices[mesh.Next(static_cast<Id>(side))]] = 1;
      }
    });
  ForEachInTurn(mesh.NumberOfVertices,
    [&](vtkIdType v)
    {
      if (flags[v])
      {
        vertices.push_back(static_cast<Id>(v));
      }
    });
  return vertices;
}

template <typename Id>
NextPatch<Id>::NextPatch(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const std::vector<Id>& vertices, Depth depth)
  : Patch(level, vertices)
  , SizesOfLevel(GetSizes(level.Mesh))
  , SizesOfPatch(GetSizes(this->Patch.Level.Mesh))
{
  if (vertices.empty())
  {
    return;
  }
  this->KeepFirstCorners(level.Mesh);
  using Kinds = SurfaceSegments;
  SurfaceSegments own;
  own.Vertices = { { Kinds::Vertex, 1, {} } };
  own.Edges = { { Kinds::Edge, 1, {} } };
  own.Faces = { { Kinds::Face, 1, {} } };
  own.Corners = { { Kinds::Face, level.Mesh.Arity, {} } };
  scheme.Prepare(this->Patch.Level);
  scheme.ListChildren(this->Patch.Level, own, this->Segments);
  this->Next = scheme.Refine(this->Patch.Level, depth);
  scheme.Prepare(this->Next);
}

/// Gives edges the first corners that they have in the level, so that rows have the same order: in
/// the patch it was the smaller one.
template <typename Id>
void NextPatch<Id>::KeepFirstCorners(const PolygonMesh<Id>& whole)
{
  Buffer<Id>& corners = this->Patch.Level.Mesh.EdgeCorners;
  ForEach(corners.size(),
    [&](vtkIdType e)
    {
      const Id corner = whole.EdgeCorners[this->Patch.Edges[e]];
      const Id face =
        corner < 0 ? -1 : SurfacePatch<Id>::Find(this->Patch.Faces, whole.GetFace(corner));
      corners[e] = face < 0 ? corners[e] : whole.Arity * face + corner % whole.Arity;
    });
}

template <typename Id>
IrregularRows<Id>::IrregularRows(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const std::vector<Id>& vertices, bool ofStep)
  : Scheme(scheme)
  , Patch(scheme, level, vertices, ofStep ? Depth::ForLastStep : Depth::ForRefinement)
{
  if (vertices.empty())
  {
    return;
  }
  if (!ofStep)
  {
    this->Flags = Buffer<unsigned char>(level.Mesh.NumberOfVertices, 0);
    std::for_each(vertices.begin(), vertices.end(), [this](Id v) { this->Flags[v] = 1; });
    return;
  }
  const SurfaceLevel<Id>& next = this->Patch.GetNext();
  scheme.ListChildren(next, this->Patch.GetSegments(), this->Children);
  const BlockOperator<Id> rows(next.Mesh.NumberOfVertices, scheme.GetNumberOfRows(next),
    [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    { scheme.AppendRows(next, next.Tags, begin, end, block); });
  this->Rows = rows.Store();
  ForEach(this->Rows.Columns.size(),
    [&](vtkIdType i) { this->Rows.Columns[i] = this->Patch.GetVertex(this->Rows.Columns[i]); });
}

template <typename Id>
void IrregularRows<Id>::Append(vtkIdType row, RowBlock<Id>& rows) const
{
  const vtkIdType own = this->Patch.Find(this->Children.Vertices, row);
  for (Id k = this->Rows.Offsets[own]; k < this->Rows.Offsets[own + 1]; ++k)
  {
    rows.Add(this->Rows.Columns[k], this->Rows.Weights[k]);
  }
}

template <typename Id>
void IrregularRows<Id>::AppendLimit(LimitKind kind, vtkIdType row, RowBlock<Id>& rows) const
{
  const vtkIdType own = this->Patch.Find(this->Patch.GetSegments().Vertices, row);
  const SurfaceLevel<Id>& next = this->Patch.GetNext();
  RowBlock<Id> block;
  this->Scheme.AppendLimitRows(next, next.Tags, kind, own, own + 1, block);
  for (std::size_t k = 0; k < block.GetNumberOfEntries(); ++k)
  {
    rows.Add(this->Patch.GetVertex(block.GetColumns()[k]), block.GetWeights()[k]);
  }
}

SUBDIVISION_COMPILE(class NextPatch);
SUBDIVISION_COMPILE(class IrregularRows);
SUBDIVISION_COMPILE_FUNCTION(FindIrregularVertices);

}
