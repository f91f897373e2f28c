// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Loop/LoopRowsOfNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Loop/LoopRegular.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace subdivision
{
namespace
{

/// A half-edge of a triangle, with the vertices and edge points of the next level around it.
template <typename Id>
struct Side
{
  Side(const PolygonMesh<Id>& mesh, Id corner)
  {
    const Id at = corner % 3;
    const Id next = at == 2 ? corner - 2 : corner + 1;
    const Id before = at == 0 ? corner + 2 : corner - 1;
    const Id vertices = static_cast<Id>(mesh.NumberOfVertices);
    this->Begin = mesh.Vertices[corner];
    this->End = mesh.Vertices[next];
    this->AfterEnd = vertices + mesh.Edges[next];
    this->BeforeBegin = vertices + mesh.Edges[before];
  }

  Id Begin;
  Id End;
  Id AfterEnd;    ///< the point of the edge that begins at the end
  Id BeforeBegin; ///< the point of the edge that ends at the beginning
};

template <typename Id>
class RowsOfNext
{
public:
  explicit RowsOfNext(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Tags(level.Tags)
    , Vertices(static_cast<Id>(level.Mesh.NumberOfVertices))
  {
  }

  bool FindEdgePoint(Id edge, Id columns[7]) const
  {
    if (this->Tags.Edges[edge] != EdgeTag::Smooth)
    {
      return false;
    }
    const Id corner = this->Mesh.EdgeCorners[edge];
    const Side<Id> one(this->Mesh, corner);
    const Side<Id> other(this->Mesh, this->Mesh.Twins[corner]);
    columns[0] = this->Vertices + edge;
    Id* to = columns + 1;
    for (const Side<Id>& side : { one, other })
    {
      *to++ = side.End;
      *to++ = side.AfterEnd;
      *to++ = side.BeforeBegin;
    }
    return one.Begin != other.Begin;
  }

  /// A vertex that is the point of an edge itself.
  bool FindNewPoint(Id vertex, Id columns[7]) const
  {
    columns[0] = vertex;
    const bool isRegular = this->Tags.Vertices[vertex] == VertexTag::Smooth &&
      FindEdgesOfEdgePoint(this->Mesh, vertex, columns + 1);
    for (int k = 1; isRegular && k < 7; ++k)
    {
      columns[k] += this->Vertices;
    }
    return isRegular;
  }

  /// Both halves of an edge.
  bool FindHalves(Id edge, Id columns[8]) const
  {
    const Id* ends = this->Mesh.EdgeVertices.data() + 2 * edge;
    if (this->Tags.Edges[edge] != EdgeTag::Smooth ||
      this->Tags.Vertices[ends[0]] != VertexTag::Smooth ||
      this->Tags.Vertices[ends[1]] != VertexTag::Smooth)
    {
      return false;
    }
    const Id corner = this->Mesh.EdgeCorners[edge];
    const Side<Id> one(this->Mesh, corner);
    const Side<Id> other(this->Mesh, this->Mesh.Twins[corner]);
    const bool isSameWay = one.Begin == other.Begin;
    const Id starts[2] = { one.BeforeBegin, isSameWay ? other.BeforeBegin : other.AfterEnd };
    const Id finishes[2] = { one.AfterEnd, isSameWay ? other.AfterEnd : other.BeforeBegin };
    const bool isAlong = one.Begin == ends[0];
    const Id* first = isAlong ? starts : finishes;
    const Id* second = isAlong ? finishes : starts;
    columns[0] = ends[0];
    columns[1] = this->Vertices + edge;
    columns[2] = first[0];
    columns[3] = first[1];
    columns[4] = this->Vertices + edge;
    columns[5] = ends[1];
    columns[6] = second[0];
    columns[7] = second[1];
    return true;
  }

  /// The three edges inside a triangle, across each of its corners.
  bool FindInside(vtkIdType face, Id columns[12]) const
  {
    const Id* x = this->Mesh.Vertices.data() + 3 * face;
    const Id* edges = this->Mesh.Edges.data() + 3 * face;
    bool areSmooth = true;
    for (int i = 0; i < 3; ++i)
    {
      areSmooth = areSmooth && this->Tags.Edges[edges[i]] == EdgeTag::Smooth;
      columns[4 * i] = this->Vertices + edges[i];
      columns[4 * i + 1] = this->Vertices + edges[(i + 2) % 3];
      columns[4 * i + 2] = x[i];
      columns[4 * i + 3] = this->Vertices + edges[(i + 1) % 3];
    }
    return areSmooth;
  }

  Id GetPoint(Id halfEdge) const { return this->Vertices + this->Mesh.Edges[halfEdge]; }

private:
  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const Id Vertices;
};

}

template <typename Id>
void AppendLoopRowsOfNext(const SurfaceLevel<Id>& level, LoopWeights weights,
  const IrregularRows<Id>& others, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const RowsOfNext<Id> next(level);
  const auto neighbour = [&](const FanStep<Id>& step)
  { return next.GetPoint(step.GetHalfEdgeIn(mesh)); };
  const vtkIdType edges = mesh.GetNumberOfEdges();
  const std::array<vtkIdType, 4> sizes{ mesh.NumberOfVertices, edges, 2 * edges,
    3 * mesh.NumberOfFaces };
  ForKindsOfRows(sizes, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      const vtkIdType before = std::accumulate(sizes.begin(), sizes.begin() + kind, vtkIdType(0));
      const auto other = [&](vtkIdType row) { others.Append(before + row, rows); };
      switch (kind)
      {
        case 0:
        {
          const vtkIdType firstNew =
            level.VerticesBefore < 0 ? last : std::clamp(level.VerticesBefore, first, last);
          AppendLoopVertices(level, level.Tags, weights, first, firstNew, neighbour, other, rows);
          AppendRegularGroups<1>(
            LoopVertex, firstNew, last, [&](vtkIdType vertex, Id* columns)
            { return next.FindNewPoint(static_cast<Id>(vertex), columns); },
            [&](vtkIdType row)
            {
              const Id vertex = static_cast<Id>(row);
              level.Tags.Vertices[vertex] == VertexTag::Smooth
                ? AppendLoopVertex(mesh, vertex, weights, neighbour, rows)
                : other(row);
            },
            rows);
          break;
        }
        case 1:
          AppendRegularGroups<1>(
            LoopVertex, first, last, [&](vtkIdType edge, Id* columns)
            { return next.FindEdgePoint(static_cast<Id>(edge), columns); }, other, rows);
          break;
        case 2:
          AppendRegularGroups<2>(
            LoopEdge, first, last, [&](vtkIdType edge, Id* columns)
            { return next.FindHalves(static_cast<Id>(edge), columns); }, other, rows);
          break;
        default:
          AppendRegularGroups<3>(
            LoopEdge, first, last, [&](vtkIdType face, Id* columns)
            { return next.FindInside(face, columns); }, other, rows);
          break;
      }
    });
}

SUBDIVISION_COMPILE_FUNCTION(AppendLoopRowsOfNext);

}
