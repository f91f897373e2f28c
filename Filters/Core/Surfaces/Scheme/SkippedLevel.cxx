// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/BlockOperator.h"

#include <atomic>

namespace subdivision
{
namespace
{

template <typename Id>
bool IsRegularEdge(const SurfaceLevel<Id>& level, vtkIdType edge)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  if (level.Tags.Edges[edge] != EdgeTag::Smooth)
  {
    return false;
  }
  const Id corner = mesh.EdgeCorners[edge];
  return mesh.Vertices[mesh.Twins[corner]] != mesh.Vertices[corner];
}

/// Whether isTrue(i) for all i of [0, size).
template <typename IsTrue>
bool AreAll(vtkIdType size, const IsTrue& isTrue)
{
  std::atomic<bool> areAll{ true };
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      while (begin < end && isTrue(begin))
      {
        ++begin;
      }
      if (begin < end)
      {
        areAll = false;
      }
    });
  return areAll;
}

}

template <typename Id>
std::vector<Id> FindIrregularVertices(const SurfaceLevel<Id>& level)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const auto isSmooth = [&level](vtkIdType v)
  { return level.Tags.Vertices[v] == VertexTag::Smooth; };
  const auto isRegular = [&level](vtkIdType e) { return IsRegularEdge(level, e); };
  std::vector<Id> vertices;
  if (AreAll(mesh.NumberOfVertices, isSmooth) && AreAll(mesh.GetNumberOfEdges(), isRegular))
  {
    return vertices;
  }
  std::vector<char> flags(static_cast<std::size_t>(mesh.NumberOfVertices));
  ForEach(mesh.NumberOfVertices, [&](vtkIdType v) { flags[v] = !isSmooth(v); });
  ForEachInTurn(mesh.GetNumberOfEdges(),
    [&](vtkIdType e)
    {
      if (!isRegular(e))
      {
        flags[mesh.EdgeVertices[2 * e]] = 1;
        flags[mesh.EdgeVertices[2 * e + 1]] = 1;
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
template <typename Renumber>
vtkIdType IrregularRows<Id>::Translate(const IdSegments& segments, vtkIdType id, const Sizes& from,
  const Sizes& to, const Renumber& renumber)
{
  vtkIdType first = 0;
  for (const IdSegment& segment : segments)
  {
    const vtkIdType size = segment.OfEach * from[segment.Kind];
    if (id < size)
    {
      return first + segment.OfEach * renumber(segment.Kind, id / segment.OfEach) +
        id % segment.OfEach;
    }
    id -= size;
    first += segment.OfEach * to[segment.Kind];
  }
  return -1;
}

template <typename Id>
IrregularRows<Id>::IrregularRows(
  const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level, const std::vector<Id>& vertices)
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
  SurfaceSegments next;
  scheme.Prepare(this->Patch.Level);
  scheme.ListChildren(this->Patch.Level, own, next);
  SurfaceLevel<Id> nextLevel = scheme.Refine(this->Patch.Level, Depth::ForLastStep);
  scheme.Prepare(nextLevel);
  scheme.ListChildren(nextLevel, next, this->Children);
  const BlockOperator<Id> rows(nextLevel.Mesh.NumberOfVertices, scheme.GetNumberOfRows(nextLevel),
    [&](vtkIdType begin, vtkIdType end, RowBlock<Id>& block)
    { scheme.AppendRows(nextLevel, nextLevel.Tags, begin, end, block); });
  this->Rows = rows.Store();
  const std::vector<Id>* const numbers[3] = { &this->Patch.Vertices, &this->Patch.Edges,
    &this->Patch.Faces };
  ForEach(this->Rows.Columns.size(),
    [&](vtkIdType i)
    {
      Id& column = this->Rows.Columns[i];
      column = static_cast<Id>(Translate(next.Vertices, column, this->SizesOfPatch,
        this->SizesOfLevel, [&](int kind, vtkIdType id) { return (*numbers[kind])[id]; }));
    });
}

/// The first corners of edges are those that they have in the level, so that rows have the same
/// order: in the patch it was the smaller one.
template <typename Id>
void IrregularRows<Id>::KeepFirstCorners(const PolygonMesh<Id>& whole)
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
void IrregularRows<Id>::Append(vtkIdType row, RowBlock<Id>& rows) const
{
  const std::vector<Id>* const numbers[3] = { &this->Patch.Vertices, &this->Patch.Edges,
    &this->Patch.Faces };
  const vtkIdType own = Translate(this->Children.Vertices, row, this->SizesOfLevel,
    this->SizesOfPatch, [&](int kind, vtkIdType id)
    { return SurfacePatch<Id>::Find(*numbers[kind], static_cast<Id>(id)); });
  for (Id k = this->Rows.Offsets[own]; k < this->Rows.Offsets[own + 1]; ++k)
  {
    rows.Add(this->Rows.Columns[k], this->Rows.Weights[k]);
  }
}

SUBDIVISION_COMPILE(class IrregularRows);
SUBDIVISION_COMPILE_FUNCTION(FindIrregularVertices);

}
