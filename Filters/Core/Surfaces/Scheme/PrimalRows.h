// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrimalRows.h
 * Rows of Loop (Arity 3) and Catmull-Clark (Arity 4) where the surface is smooth: of vertices, and
 * of the whole step from the next level, which is not made (SkippedLevel.h).
 *
 * A row of a vertex reads Arity - 2 others of each face around it: the other end of the edge by
 * which a walk enters the face and, in a quad, the vertex opposite. members(step, others) writes
 * these.
 */
#ifndef SubdivisionObjects_PrimalRows_h
#define SubdivisionObjects_PrimalRows_h

#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/PrimalRefinement.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include <numeric>

namespace subdivision
{

/// The mask of the point of a quad.
inline constexpr std::array<double, 4> QuadOfFace{ 1. / 4., 1. / 4., 1. / 4., 1. / 4. };

/// Appends the rows of vertices [begin, end). `mask`: of a vertex of six triangles or four quads.
/// find(v, columns) writes the row of a smooth vertex that a step made without a walk, or returns
/// false. other(v, steps) appends the entries of any other vertex, with the walk around it if it is
/// smooth.
template <int Arity, std::size_t N, typename Id, typename Members, typename Find, typename Other>
void AppendPrimalVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  const std::array<double, N>& mask, vtkIdType begin, vtkIdType end, const Members& members,
  const Find& find, const Other& other, RowBlock<Id>& rows)
{
  constexpr std::size_t faces = (N - 1) / (Arity - 2);
  AppendVertexRows(
    level.Mesh, tags, mask, level.VerticesBefore, begin, end,
    [&](Id vertex, const std::vector<FanStep<Id>>& steps, Id* columns)
    {
      *columns++ = vertex;
      const bool isRegular = level.Mesh.Arity == Arity && steps.size() == faces;
      for (std::size_t k = 0; isRegular && k < faces; ++k, columns += Arity - 2)
      {
        members(steps[k], columns);
      }
      return isRegular;
    },
    find, other, rows);
}

/// The vertices of the next level, all from this level, of which all faces have Arity corners.
template <typename Id, int Arity>
class PrimalRowsOfNext
{
public:
  explicit PrimalRowsOfNext(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Tags(level.Tags)
    , EdgePoints(static_cast<Id>(level.Mesh.NumberOfVertices))
    , FacePoints(static_cast<Id>(level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges()))
  {
  }

  void FindMembers(const FanStep<Id>& step, Id* others) const
  {
    this->FindMembers(step.GetHalfEdgeIn(this->Mesh), step.Corner, others);
  }

  /// Whether all vertices of the faces of an edge, or of a face, are regular.
  bool IsRegularEdge(const IrregularRows<Id>& others, Id edge) const
  {
    const Id corner = this->Mesh.EdgeCorners[edge];
    return this->IsRegularFace(others, corner / Arity) &&
      this->IsRegularFace(others, this->Mesh.Twins[corner] / Arity);
  }
  bool IsRegularFace(const IrregularRows<Id>& others, vtkIdType face) const
  {
    const Id* x = this->Mesh.Vertices.data() + Arity * face;
    return others.IsEmpty() ||
      std::none_of(x, x + Arity, [&others](Id v) { return others.IsIrregular(v); });
  }

  bool FindEdgePoint(Id edge, Id* columns) const
  {
    if (this->Tags.Edges[edge] != EdgeTag::Smooth)
    {
      return false;
    }
    const Side one(*this, this->Mesh.EdgeCorners[edge]);
    const Side other(*this, this->Mesh.Twins[this->Mesh.EdgeCorners[edge]]);
    *columns++ = this->EdgePoints + edge;
    for (const Side& side : { one, other })
    {
      *columns++ = side.End;
      *columns++ = side.AfterEnd;
      if (Arity == 4)
      {
        *columns++ = side.Middle;
      }
      *columns++ = side.BeforeBegin;
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
  bool FindNewPoint(Id vertex, Id* columns) const
  {
    *columns++ = vertex;
    if (Arity == 3)
    {
      const bool isRegular = FindRingOfEdgePoint<true>(this->Mesh, vertex, columns);
      for (int k = 0; isRegular && k < 6; ++k)
      {
        columns[k] += this->EdgePoints;
      }
      return isRegular;
    }
    Id quads[4];
    Id own[2];
    const bool isRegular = FindQuadsOfNewPoint(this->Mesh, vertex, quads, own);
    for (int k = 0; isRegular && k < 4; ++k, columns += 2)
    {
      this->FindMembers(quads[k] + own[k % 2], quads[k], columns);
    }
    return isRegular;
  }

  /// Both halves of an edge: the two faces have the vertices opposite to each.
  bool FindHalves(Id edge, Id* columns) const
  {
    constexpr int ofFace = Arity - 2;
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
    Id* const later = columns + 2 + 2 * ofFace;
    Id* first = isAlong ? columns : later;
    Id* second = isAlong ? later : columns;
    one.WriteAtBegin(first + 2);
    isSameWay ? other.WriteAtBegin(first + 2 + ofFace) : other.WriteAtEnd(first + 2 + ofFace);
    one.WriteAtEnd(second + 2);
    isSameWay ? other.WriteAtEnd(second + 2 + ofFace) : other.WriteAtBegin(second + 2 + ofFace);
    columns[0] = ends[0];
    columns[1] = this->EdgePoints + edge;
    later[0] = this->EdgePoints + edge;
    later[1] = ends[1];
    return true;
  }

  /// The edges inside a face: across each corner of a triangle, or from the point of each edge of a
  /// quad to its own.
  bool FindInside(vtkIdType face, Id* columns) const
  {
    const Id* x = this->Mesh.Vertices.data() + Arity * face;
    const Id* edges = this->Mesh.Edges.data() + Arity * face;
    bool areSmooth = true;
    for (int k = 0; k < Arity; ++k)
    {
      areSmooth = areSmooth && this->Tags.Edges[edges[k]] == EdgeTag::Smooth;
      const int next = (k + 1) % Arity;
      const Id before = this->EdgePoints + edges[(k + Arity - 1) % Arity];
      *columns++ = this->EdgePoints + edges[k];
      *columns++ = Arity == 3 ? before : this->FacePoints + static_cast<Id>(face);
      *columns++ = x[k];
      if (Arity == 4)
      {
        *columns++ = before;
      }
      *columns++ = this->EdgePoints + edges[next];
      if (Arity == 4)
      {
        *columns++ = x[next];
      }
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
  /// A half-edge, with the vertices of the next level around it.
  struct Side
  {
    Side(const PrimalRowsOfNext& of, Id corner)
    {
      const Id face = corner / Arity;
      const Id own = corner - Arity * face;
      const Id next = own == Arity - 1 ? corner - (Arity - 1) : corner + 1;
      const Id before = own == 0 ? corner + (Arity - 1) : corner - 1;
      this->Begin = of.Mesh.Vertices[corner];
      this->End = of.Mesh.Vertices[next];
      this->AfterEnd = of.EdgePoints + of.Mesh.Edges[next];
      this->Middle = of.FacePoints + face;
      this->BeforeBegin = of.EdgePoints + of.Mesh.Edges[before];
    }
    /// The vertices opposite to the half at the beginning, or at the end.
    void WriteAtBegin(Id* to) const
    {
      to[0] = this->BeforeBegin;
      to[Arity - 3] = Arity == 3 ? this->BeforeBegin : this->Middle;
    }
    void WriteAtEnd(Id* to) const
    {
      to[0] = this->Middle;
      to[Arity - 3] = this->AfterEnd;
    }

    Id Begin;
    Id End;
    Id AfterEnd;    ///< the point of the edge that begins at the end
    Id Middle;      ///< the point of the face, in quads
    Id BeforeBegin; ///< the point of the edge that ends at the beginning
  };

  /// The point of the edge of a half-edge and, in a quad, the point of the face of a corner.
  void FindMembers(Id halfEdge, Id corner, Id* others) const
  {
    others[0] = this->EdgePoints + this->Mesh.Edges[halfEdge];
    if (Arity == 4)
    {
      others[1] = this->FacePoints + corner / 4;
    }
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const Id EdgePoints;
  const Id FacePoints;
};

/// Appends limit rows of the next level: `mask` is that of its regular vertices, and smooth(v,
/// steps, members) appends the entries of a vertex of this level with any number of faces. What is
/// at irregular vertices comes from `others`, since curves change the rules beside them.
template <int Arity, std::size_t N, typename Id, typename Smooth>
void AppendPrimalLimitsOfNext(const SurfaceLevel<Id>& level, const std::array<double, N>& mask,
  const Smooth& smooth, const IrregularRows<Id>& others, LimitKind kind, vtkIdType begin,
  vtkIdType end, RowBlock<Id>& rows)
{
  const PrimalRowsOfNext<Id, Arity> next(level);
  const auto members = [&](const FanStep<Id>& step, Id* to) { next.FindMembers(step, to); };
  const vtkIdType vertices = level.Mesh.NumberOfVertices;
  const vtkIdType edges = level.Mesh.GetNumberOfEdges();
  const auto appendOther = [&](vtkIdType row) { others.AppendLimit(kind, row, rows); };
  ForKindsOfRows<3>({ vertices, edges, Arity == 4 ? level.Mesh.NumberOfFaces : 0 }, begin, end,
    [&](std::size_t which, vtkIdType first, vtkIdType last)
    {
      switch (which)
      {
        case 0:
          AppendVertexRows(
            level.Mesh, level.Tags, mask, level.VerticesBefore, first, last,
            [&](Id vertex, const std::vector<FanStep<Id>>& steps, Id* columns)
            {
              const bool isRegular =
                steps.size() == (N - 1) / (Arity - 2) && !others.IsIrregular(vertex);
              *columns++ = vertex;
              for (std::size_t k = 0; isRegular && k < steps.size(); ++k, columns += Arity - 2)
              {
                members(steps[k], columns);
              }
              return isRegular;
            },
            [&](Id vertex, Id* columns)
            { return !others.IsIrregular(vertex) && next.FindNewPoint(vertex, columns); },
            [&](Id vertex, const std::vector<FanStep<Id>>& steps)
            { others.IsIrregular(vertex) ? appendOther(vertex) : smooth(vertex, steps, members); },
            rows);
          break;
        case 1:
          AppendRegularGroups<1>(
            mask, first, last,
            [&](vtkIdType edge, Id* columns)
            {
              return next.FindEdgePoint(static_cast<Id>(edge), columns) &&
                next.IsRegularEdge(others, static_cast<Id>(edge));
            },
            [&](vtkIdType edge) { appendOther(vertices + edge); }, rows);
          break;
        default:
          if constexpr (Arity == 4)
          {
            AppendRegularGroups<1>(
              mask, first, last,
              [&](vtkIdType face, Id* columns)
              {
                next.FindFacePoint(face, columns);
                return next.IsRegularFace(others, face);
              },
              [&](vtkIdType face) { appendOther(vertices + edges + face); }, rows);
          }
      }
    });
}

/// Appends the rows of the step from the next level. With V vertices, E edges and F faces on this
/// level they belong to its vertices, to the points of its edges and quads, to the halves of its
/// edges, to the edges inside each face, and to the children of each quad. smooth(v, steps,
/// members) appends the entries of a smooth vertex with any number of faces.
template <int Arity, std::size_t V, std::size_t E, typename Id, typename Smooth>
void AppendPrimalRowsOfNext(const SurfaceLevel<Id>& level, const std::array<double, V>& ofVertex,
  const std::array<double, E>& ofEdge, const Smooth& smooth, const IrregularRows<Id>& others,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const PrimalRowsOfNext<Id, Arity> next(level);
  const auto members = [&](const FanStep<Id>& step, Id* to) { next.FindMembers(step, to); };
  const vtkIdType edges = level.Mesh.GetNumberOfEdges();
  const vtkIdType faces = level.Mesh.NumberOfFaces;
  const vtkIdType quads = Arity == 4 ? faces : 0;
  const std::array<vtkIdType, 6> sizes{ level.Mesh.NumberOfVertices, edges, quads, 2 * edges,
    Arity * faces, 4 * quads };
  ForKindsOfRows(sizes, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      const vtkIdType before = std::accumulate(sizes.begin(), sizes.begin() + kind, vtkIdType(0));
      const auto other = [&](vtkIdType row) { others.Append(before + row, rows); };
      switch (kind)
      {
        case 0:
          AppendPrimalVertices<Arity>(
            level, level.Tags, ofVertex, first, last, members,
            [&](Id vertex, Id* columns) { return next.FindNewPoint(vertex, columns); },
            [&](Id vertex, const std::vector<FanStep<Id>>& steps)
            { steps.empty() ? other(vertex) : smooth(vertex, steps, members); }, rows);
          break;
        case 1:
          AppendRegularGroups<1>(
            ofVertex, first, last, [&](vtkIdType edge, Id* columns)
            { return next.FindEdgePoint(static_cast<Id>(edge), columns); }, other, rows);
          break;
        case 2:
          rows.AddRun(ofVertex, last - first,
            [&](vtkIdType i, Id* columns)
            {
              next.FindFacePoint(first + i, columns);
              return true;
            });
          break;
        case 3:
          AppendRegularGroups<2>(
            ofEdge, first, last, [&](vtkIdType edge, Id* columns)
            { return next.FindHalves(static_cast<Id>(edge), columns); }, other, rows);
          break;
        case 4:
          AppendRegularGroups<Arity>(
            ofEdge, first, last, [&](vtkIdType face, Id* columns)
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

}

#endif
