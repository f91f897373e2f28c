// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Butterfly/ButterflyRowsOfNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Butterfly/ButterflyRegular.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <array>

namespace subdivision
{
namespace
{

template <typename Id>
class RowsOfNext
{
public:
  explicit RowsOfNext(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Valences(level.Places)
    , Tags(level.Tags)
    , Vertices(static_cast<Id>(level.Mesh.NumberOfVertices))
  {
  }

  /// Writes the columns of one half of an edge; false: it has another mask than ButterflyEdge.
  bool FindHalf(Id edge, int half, Id columns[8]) const
  {
    const Id end = this->Mesh.EdgeVertices[2 * edge + half];
    if (!this->IsSmooth(edge) || this->GetFaces(end) != 6)
    {
      return false;
    }
    columns[half] = end;
    columns[1 - half] = this->Vertices + edge;
    const Id first = this->Mesh.EdgeCorners[edge];
    Id* next = columns + 2;
    for (const Id side : { first, this->Mesh.Twins[first] })
    {
      // The edges of the triangle at this end, and opposite.
      const bool begins = this->Mesh.Vertices[side] == end;
      const Id at = begins ? this->Mesh.Previous(side) : this->Mesh.Next(side);
      const Id opposite = begins ? this->Mesh.Next(side) : this->Mesh.Previous(side);
      *next++ = this->GetPoint(at);
      next[half] = this->GetBeyond(at, end);
      next[1 - half] = this->GetPoint(opposite);
      next += 2;
    }
    return true;
  }

  /// Both halves.
  bool FindHalves(Id edge, Id columns[16]) const
  {
    return this->FindHalf(edge, 0, columns) && this->FindHalf(edge, 1, columns + 8);
  }

  /// The three edges inside a triangle, across each of its corners.
  bool FindInside(vtkIdType face, Id columns[24]) const
  {
    const Id first = static_cast<Id>(3 * face);
    const Id* x = this->Mesh.Vertices.data() + first;
    const Id* edges = this->Mesh.Edges.data() + first;
    for (int i = 0; i < 3; ++i)
    {
      if (!this->IsSmooth(edges[i]))
      {
        return false;
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const int last = (i + 2) % 3;
      *columns++ = this->Vertices + edges[i];
      *columns++ = this->Vertices + edges[last];
      *columns++ = x[i];
      *columns++ = this->GetBeyond(first + i, x[i]);
      *columns++ = this->GetBeyond(first + last, x[i]);
      *columns++ = this->Vertices + edges[next];
      *columns++ = x[next];
      *columns++ = x[last];
    }
    return true;
  }

  /// Appends the entries of one half of an edge; false: IrregularRows has them.
  bool AppendHalf(Id edge, int half, RowBlock<Id>& rows) const
  {
    std::array<Id, 8> columns;
    if (this->FindHalf(edge, half, columns.data()))
    {
      for (std::size_t k = 0; k < columns.size(); ++k)
      {
        rows.Add(columns[k], ButterflyEdge[k]);
      }
      return true;
    }
    const Id end = this->Mesh.EdgeVertices[2 * edge + half];
    if (!this->IsSmooth(edge) || this->GetFaces(end) == 0)
    {
      return false;
    }
    const Id corner = GetCornerAt(this->Mesh, this->Mesh.EdgeCorners[edge], end);
    AppendButterflyRing(
      this->Mesh, edge, end, corner, 1., [&](Id around) { return this->Vertices + around; }, rows);
    return true;
  }

private:
  bool IsSmooth(Id edge) const { return this->Tags.Edges[edge] == EdgeTag::Smooth; }
  /// The number of faces of a vertex with smooth edges all around; otherwise 0.
  Id GetFaces(Id vertex) const
  {
    return this->Tags.Vertices[vertex] == VertexTag::Smooth ? this->Valences[vertex] : 0;
  }
  Id GetPoint(Id halfEdge) const { return this->Vertices + this->Mesh.Edges[halfEdge]; }
  /// The point of the other edge at a vertex, in the triangle beyond one of its edges.
  Id GetBeyond(Id halfEdge, Id vertex) const
  {
    const Id twin = this->Mesh.Twins[halfEdge];
    return this->GetPoint(
      this->Mesh.Vertices[twin] == vertex ? this->Mesh.Previous(twin) : this->Mesh.Next(twin));
  }

  const PolygonMesh<Id>& Mesh;
  const Buffer<Id>& Valences;
  const SurfaceTags<Id>& Tags;
  const Id Vertices;
};

}

template <typename Id>
void AppendButterflyRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const RowsOfNext<Id> next(level);
  const vtkIdType edges = mesh.GetNumberOfEdges();
  const vtkIdType vertices = mesh.NumberOfVertices + edges;
  ForKindsOfRows<3>({ vertices, 2 * edges, 3 * mesh.NumberOfFaces }, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      switch (kind)
      {
        case 0:
          rows.AddCopies(first, last - first);
          break;
        case 1:
          AppendRegularGroups<2>(
            ButterflyEdge, first, last, [&](vtkIdType edge, Id* columns)
            { return next.FindHalves(static_cast<Id>(edge), columns); },
            [&](vtkIdType row)
            {
              if (!next.AppendHalf(static_cast<Id>(row / 2), static_cast<int>(row % 2), rows))
              {
                others.Append(vertices + row, rows);
              }
            },
            rows);
          break;
        default:
          AppendRegularGroups<3>(
            ButterflyEdge, first, last,
            [&](vtkIdType face, Id* columns) { return next.FindInside(face, columns); },
            [&](vtkIdType row) { others.Append(vertices + 2 * edges + row, rows); }, rows);
          break;
      }
    });
}

SUBDIVISION_COMPILE_FUNCTION(AppendButterflyRowsOfNext);

}
