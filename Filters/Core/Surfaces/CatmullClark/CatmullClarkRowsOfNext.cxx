// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/CatmullClark/CatmullClarkRowsOfNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/CatmullClark/CatmullClarkRegular.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace subdivision
{
namespace
{

/// The vertices of the next level, all from this level.
template <typename Id>
class RowsOfNext
{
public:
  explicit RowsOfNext(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Tags(level.Tags)
    , EdgePoints(static_cast<Id>(level.Mesh.NumberOfVertices))
    , FacePoints(static_cast<Id>(level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges()))
  {
  }

  /// The point of the edge of a half-edge, and the point of its face.
  Id GetPoint(Id halfEdge) const { return this->EdgePoints + this->Mesh.Edges[halfEdge]; }
  Id GetMiddle(Id corner) const { return this->FacePoints + corner / 4; }

  bool FindEdgePoint(Id edge, Id columns[9]) const
  {
    if (this->Tags.Edges[edge] != EdgeTag::Smooth)
    {
      return false;
    }
    const Side one(*this, this->Mesh.EdgeCorners[edge]);
    const Side other(*this, this->Mesh.Twins[this->Mesh.EdgeCorners[edge]]);
    columns[0] = this->EdgePoints + edge;
    Id* to = columns + 1;
    for (const Side& side : { one, other })
    {
      *to++ = side.End;
      *to++ = side.AfterEnd;
      *to++ = side.Middle;
      *to++ = side.BeforeBegin;
    }
    return one.Begin != other.Begin;
  }

  void FindFacePoint(vtkIdType face, Id columns[9]) const
  {
    const Id* x = this->Mesh.Vertices.data() + 4 * face;
    const Id* edges = this->Mesh.Edges.data() + 4 * face;
    columns[0] = this->FacePoints + static_cast<Id>(face);
    for (int k = 0; k < 4; ++k)
    {
      columns[2 * k + 1] = this->EdgePoints + edges[(k + 3) % 4];
      columns[2 * k + 2] = x[k];
    }
  }

  /// A vertex that is the point of an edge or a face itself.
  bool FindNewPoint(Id vertex, Id columns[9]) const
  {
    Id quads[4];
    Id own[2];
    if (this->Tags.Vertices[vertex] != VertexTag::Smooth ||
      !FindQuadsOfNewPoint(this->Mesh, vertex, quads, own))
    {
      return false;
    }
    columns[0] = vertex;
    for (int k = 0; k < 4; ++k)
    {
      columns[2 * k + 1] = this->GetPoint(quads[k] + own[k % 2]);
      columns[2 * k + 2] = this->GetMiddle(quads[k]);
    }
    return true;
  }

  /// Both halves of an edge.
  bool FindHalves(Id edge, Id columns[12]) const
  {
    const Id* ends = this->Mesh.EdgeVertices.data() + 2 * edge;
    if (this->Tags.Edges[edge] != EdgeTag::Smooth ||
      this->Tags.Vertices[ends[0]] != VertexTag::Smooth ||
      this->Tags.Vertices[ends[1]] != VertexTag::Smooth)
    {
      return false;
    }
    const Side one(*this, this->Mesh.EdgeCorners[edge]);
    const Side other(*this, this->Mesh.Twins[this->Mesh.EdgeCorners[edge]]);
    const bool isSameWay = one.Begin == other.Begin;
    const bool isAlong = one.Begin == ends[0];
    Id* first = columns + (isAlong ? 0 : 6);
    Id* second = columns + (isAlong ? 6 : 0);
    one.WriteAtBegin(first + 2);
    isSameWay ? other.WriteAtBegin(first + 4) : other.WriteAtEnd(first + 4);
    one.WriteAtEnd(second + 2);
    isSameWay ? other.WriteAtEnd(second + 4) : other.WriteAtBegin(second + 4);
    columns[0] = ends[0];
    columns[1] = this->EdgePoints + edge;
    columns[6] = this->EdgePoints + edge;
    columns[7] = ends[1];
    return true;
  }

  /// The four edges inside a quad, from the points of its edges to its own.
  bool FindInside(vtkIdType face, Id columns[24]) const
  {
    const Id* x = this->Mesh.Vertices.data() + 4 * face;
    const Id* edges = this->Mesh.Edges.data() + 4 * face;
    bool areSmooth = true;
    for (int k = 0; k < 4; ++k)
    {
      areSmooth = areSmooth && this->Tags.Edges[edges[k]] == EdgeTag::Smooth;
      const int next = (k + 1) % 4;
      Id* row = columns + 6 * k;
      row[0] = this->EdgePoints + edges[k];
      row[1] = this->FacePoints + static_cast<Id>(face);
      row[2] = x[k];
      row[3] = this->EdgePoints + edges[(k + 3) % 4];
      row[4] = this->EdgePoints + edges[next];
      row[5] = x[next];
    }
    return areSmooth;
  }

  /// The four children of a quad.
  bool FindChildren(vtkIdType face, Id columns[16]) const
  {
    const Id* x = this->Mesh.Vertices.data() + 4 * face;
    const Id* edges = this->Mesh.Edges.data() + 4 * face;
    for (int k = 0; k < 4; ++k)
    {
      Id* row = columns + 4 * k;
      row[0] = x[k];
      row[1] = this->EdgePoints + edges[k];
      row[2] = this->FacePoints + static_cast<Id>(face);
      row[3] = this->EdgePoints + edges[(k + 3) % 4];
    }
    const auto isSmooth = [this](Id v) { return this->Tags.Vertices[v] == VertexTag::Smooth; };
    return this->Tags.Sectors.empty() || // no corner may be flat
      std::all_of(x, x + 4, isSmooth);
  }

private:
  /// A half-edge of a quad, with the vertices of the next level around it.
  struct Side
  {
    Side(const RowsOfNext& of, Id corner)
    {
      const Id next = corner % 4 == 3 ? corner - 3 : corner + 1;
      const Id before = corner % 4 == 0 ? corner + 3 : corner - 1;
      this->Begin = of.Mesh.Vertices[corner];
      this->End = of.Mesh.Vertices[next];
      this->AfterEnd = of.GetPoint(next);
      this->Middle = of.GetMiddle(corner);
      this->BeforeBegin = of.GetPoint(before);
    }
    /// The vertices opposite to the half at the beginning, or at the end.
    void WriteAtBegin(Id to[2]) const
    {
      to[0] = this->BeforeBegin;
      to[1] = this->Middle;
    }
    void WriteAtEnd(Id to[2]) const
    {
      to[0] = this->Middle;
      to[1] = this->AfterEnd;
    }

    Id Begin;
    Id End;
    Id AfterEnd;    ///< the point of the edge that begins at the end
    Id Middle;      ///< the point of the face
    Id BeforeBegin; ///< the point of the edge that ends at the beginning
  };

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const Id EdgePoints;
  const Id FacePoints;
};

}

template <typename Id>
void AppendCatmullClarkRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const RowsOfNext<Id> next(level);
  const auto members = [&](const FanStep<Id>& step, Id* two)
  {
    two[0] = next.GetPoint(step.GetHalfEdgeIn(mesh));
    two[1] = next.GetMiddle(step.Corner);
  };
  const auto appendVertex = [&](Id vertex, const std::vector<FanStep<Id>>& steps)
  { steps.empty() ? others.Append(vertex, rows) : AppendQuadVertex(vertex, steps, members, rows); };
  const vtkIdType edges = mesh.GetNumberOfEdges();
  const vtkIdType faces = mesh.NumberOfFaces;
  const std::array<vtkIdType, 6> sizes{ mesh.NumberOfVertices, edges, faces, 2 * edges, 4 * faces,
    4 * faces };
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
          AppendQuadVertices(level, level.Tags, first, firstNew, members, appendVertex, rows);
          AppendRegularGroups<1>(
            QuadsAtVertex, firstNew, last, [&](vtkIdType vertex, Id* columns)
            { return next.FindNewPoint(static_cast<Id>(vertex), columns); },
            [&](vtkIdType row)
            {
              const Id vertex = static_cast<Id>(row);
              std::vector<FanStep<Id>> steps;
              if (level.Tags.Vertices[vertex] == VertexTag::Smooth)
              {
                VisitCycle(mesh, mesh.VertexCorners[vertex],
                  [&](const FanStep<Id>& step) { steps.push_back(step); });
              }
              appendVertex(vertex, steps);
            },
            rows);
          break;
        }
        case 1:
          AppendRegularGroups<1>(
            QuadsAtVertex, first, last, [&](vtkIdType edge, Id* columns)
            { return next.FindEdgePoint(static_cast<Id>(edge), columns); }, other, rows);
          break;
        case 2:
          rows.AddRun(QuadsAtVertex, last - first,
            [&](vtkIdType i, Id* columns)
            {
              next.FindFacePoint(first + i, columns);
              return true;
            });
          break;
        case 3:
          AppendRegularGroups<2>(
            QuadsAtEdge, first, last, [&](vtkIdType edge, Id* columns)
            { return next.FindHalves(static_cast<Id>(edge), columns); }, other, rows);
          break;
        case 4:
          AppendRegularGroups<4>(
            QuadsAtEdge, first, last, [&](vtkIdType face, Id* columns)
            { return next.FindInside(face, columns); }, other, rows);
          break;
        default:
          AppendRegularGroups<4>(
            QuadOfFace, first, last, [&](vtkIdType face, Id* columns)
            { return next.FindChildren(face, columns); }, other, rows);
          break;
      }
    });
}

template <typename Id>
void GetCatmullClarkParentsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType edgePoints = mesh.NumberOfVertices;
  const vtkIdType facePoints = edgePoints + mesh.GetNumberOfEdges();
  const vtkIdType half = row - facePoints - mesh.NumberOfFaces;
  const vtkIdType inside = half - 2 * mesh.GetNumberOfEdges();
  const vtkIdType child = inside - 4 * mesh.NumberOfFaces;
  if (half < 0)
  {
    parents.assign({ row });
  }
  else if (inside < 0)
  {
    parents.assign({ mesh.EdgeVertices[half], edgePoints + half / 2 });
  }
  else if (child < 0)
  {
    parents.assign({ edgePoints + mesh.Edges[inside], facePoints + inside / 4 });
  }
  else
  {
    const vtkIdType before = child % 4 == 0 ? child + 3 : child - 1;
    parents.assign({ mesh.Vertices[child], edgePoints + mesh.Edges[child], facePoints + child / 4,
      edgePoints + mesh.Edges[before] });
  }
}

SUBDIVISION_COMPILE_FUNCTION(AppendCatmullClarkRowsOfNext);
SUBDIVISION_COMPILE_FUNCTION(GetCatmullClarkParentsOfNext);

}
