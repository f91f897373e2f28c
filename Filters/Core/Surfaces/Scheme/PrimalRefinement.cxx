// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/PrimalRefinement.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

namespace subdivision
{
namespace
{

/// Triangle (x0, x1, x2) becomes (x0, x01, x02), (x01, x1, x12), (x02, x12, x2), (x01, x12, x02).
template <typename Id>
struct TriangleSplit
{
  explicit TriangleSplit(const PolygonMesh<Id>& mesh)
    : Mesh(mesh)
  {
  }
  static constexpr int Arity = 3;

  vtkIdType GetNumberOfVertices() const
  {
    return this->Mesh.NumberOfVertices + this->Mesh.GetNumberOfEdges();
  }
  vtkIdType GetNumberOfFaces() const { return 4 * this->Mesh.NumberOfFaces; }

  /// The two halves of a half-edge, as corners of the next level: the first at its vertex, the
  /// second at the edge point.
  Id GetStart(Id corner) const { return 12 * (corner / 3) + 4 * (corner % 3); }
  Id GetEnd(Id corner) const
  {
    constexpr Id ends[3] = { 3, 7, 2 };
    return 12 * (corner / 3) + ends[corner % 3];
  }

  template <typename Out>
  void SetVertices(vtkIdType face, Out* out) const
  {
    const Id* x = this->Mesh.Vertices.data() + 3 * face;
    const Id* e = this->Mesh.Edges.data() + 3 * face;
    const Id first = static_cast<Id>(this->Mesh.NumberOfVertices);
    const Id x01 = first + e[0];
    const Id x12 = first + e[1];
    const Id x02 = first + e[2];
    const Id children[12] = { x[0], x01, x02, x01, x[1], x12, x02, x12, x[2], x01, x12, x02 };
    std::copy(children, children + 12, out + 12 * face);
  }

  /// Half-edges inside a face: their edges and twins.
  void SetInside(vtkIdType face, PolygonMesh<Id>& out) const
  {
    constexpr Id outer[3] = { 1, 5, 6 };
    constexpr Id middle[3] = { 11, 9, 10 };
    const Id first = static_cast<Id>(12 * face);
    const Id* e = this->Mesh.Edges.data() + 3 * face;
    for (int i = 0; i < 3; ++i)
    {
      const Id edge = static_cast<Id>(2 * this->Mesh.GetNumberOfEdges() + 3 * face + i);
      out.Edges[first + outer[i]] = edge;
      out.Edges[first + middle[i]] = edge;
      out.Twins[first + outer[i]] = first + middle[i];
      out.Twins[first + middle[i]] = first + outer[i];
      out.EdgeCorners[edge] = first + outer[i];
      out.EdgeVertices[2 * edge] = static_cast<Id>(this->Mesh.NumberOfVertices) + e[i];
      out.EdgeVertices[2 * edge + 1] =
        static_cast<Id>(this->Mesh.NumberOfVertices) + e[(i + 2) % 3];
    }
  }
  void SetFacePoint(vtkIdType, PolygonMesh<Id>&) const {}

  const PolygonMesh<Id>& Mesh;
};

/// The child of corner c: its vertex, the point of its edge, the face point, the point of the
/// previous corner's edge.
template <typename Id>
struct QuadSplit
{
  explicit QuadSplit(const PolygonMesh<Id>& mesh)
    : Mesh(mesh)
  {
  }
  static constexpr int Arity = 4;

  vtkIdType GetNumberOfVertices() const
  {
    return this->Mesh.NumberOfVertices + this->Mesh.GetNumberOfEdges() + this->Mesh.NumberOfFaces;
  }
  vtkIdType GetNumberOfFaces() const { return this->Mesh.GetNumberOfCorners(); }

  Id GetStart(Id corner) const { return 4 * corner; }
  Id GetEnd(Id corner) const { return 4 * this->Mesh.Next(corner) + 3; }

  template <typename Out>
  void SetVertices(vtkIdType face, Out* out) const
  {
    const Id f = static_cast<Id>(face);
    const Id first = this->Mesh.GetFirst(f);
    const Id last = first + this->Mesh.GetSize(f) - 1;
    const Id vertices = static_cast<Id>(this->Mesh.NumberOfVertices);
    const Id middle = vertices + static_cast<Id>(this->Mesh.GetNumberOfEdges()) + f;
    Id before = vertices + this->Mesh.Edges[last];
    for (Id c = first; c <= last; ++c)
    {
      const Id after = vertices + this->Mesh.Edges[c];
      Out* quad = out + 4 * static_cast<vtkIdType>(c);
      quad[0] = this->Mesh.Vertices[c];
      quad[1] = after;
      quad[2] = middle;
      quad[3] = before;
      before = after;
    }
  }

  void SetInside(vtkIdType face, PolygonMesh<Id>& out) const
  {
    const Id f = static_cast<Id>(face);
    const Id first = this->Mesh.GetFirst(f);
    const Id last = first + this->Mesh.GetSize(f) - 1;
    const Id vertices = static_cast<Id>(this->Mesh.NumberOfVertices);
    const Id edges = static_cast<Id>(this->Mesh.GetNumberOfEdges());
    for (Id c = first; c <= last; ++c)
    {
      const Id next = c == last ? first : c + 1;
      const Id edge = 2 * edges + c;
      out.Edges[4 * c + 1] = edge;
      out.Edges[4 * next + 2] = edge;
      out.Twins[4 * c + 1] = 4 * next + 2;
      out.Twins[4 * next + 2] = 4 * c + 1;
      out.EdgeCorners[edge] = 4 * c + 1;
      out.EdgeVertices[2 * edge] = vertices + this->Mesh.Edges[c];
      out.EdgeVertices[2 * edge + 1] = vertices + edges + f;
    }
  }
  void SetFacePoint(vtkIdType face, PolygonMesh<Id>& out) const
  {
    out.VertexCorners[this->Mesh.NumberOfVertices + this->Mesh.GetNumberOfEdges() + face] =
      4 * this->Mesh.GetFirst(static_cast<Id>(face)) + 2;
  }

  const PolygonMesh<Id>& Mesh;
};

template <typename Id, typename Split>
class PrimalRefiner
{
public:
  explicit PrimalRefiner(const SurfaceLevel<Id>& level)
    : Level(level)
    , Mesh(level.Mesh)
    , Children(level.Mesh)
  {
  }

  SurfaceLevel<Id> Run(Depth depth)
  {
    SurfaceLevel<Id> next;
    next.Step = this->Level.Step + 1;
    next.VerticesBefore = this->Mesh.NumberOfVertices;
    PolygonMesh<Id>& out = next.Mesh;
    out.Arity = Split::Arity;
    out.NumberOfVertices = this->Children.GetNumberOfVertices();
    out.NumberOfFaces = this->Children.GetNumberOfFaces();
    const vtkIdType corners = out.NumberOfFaces * Split::Arity;
    const vtkIdType edges = 2 * this->Mesh.GetNumberOfEdges() + this->Mesh.GetNumberOfCorners();
    const bool isWhole = !IsLast(depth);
    if (depth != Depth::ForCounts)
    {
      out.Vertices = Buffer<Id>(corners);
    }
    if (depth == Depth::ForOutput)
    {
      this->WriteFaces(out.Vertices.data());
    }
    if (isWhole || !this->Level.Lines.empty())
    {
      out.EdgeVertices = Buffer<Id>(2 * edges);
      this->SplitEdgeVertices(out);
    }
    if (isWhole)
    {
      out.Edges = Buffer<Id>(corners);
      out.Twins = Buffer<Id>(corners);
      out.EdgeCorners = Buffer<Id>(edges);
      out.VertexCorners = Buffer<Id>(out.NumberOfVertices);
      this->SplitFaces(out);
      this->SplitEdges(out);
      this->SplitJoints(out);
    }
    this->SplitLines(next.Lines);
    return next;
  }

  template <typename Out>
  void WriteFaces(Out* ids) const
  {
    ForEach(this->Mesh.NumberOfFaces, [&](vtkIdType f) { this->Children.SetVertices(f, ids); });
  }

private:
  void SplitFaces(PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.NumberOfFaces,
      [&](vtkIdType f)
      {
        this->Children.SetVertices(f, out.Vertices.data());
        this->Children.SetInside(f, out);
        this->Children.SetFacePoint(f, out);
        const Id first = this->Mesh.GetFirst(static_cast<Id>(f));
        const Id end = first + this->Mesh.GetSize(static_cast<Id>(f));
        for (Id c = first; c < end; ++c)
        {
          const Id edge = this->Mesh.Edges[c];
          const Id twin = this->Mesh.Twins[c];
          const bool along = this->Mesh.EdgeVertices[2 * edge] == this->Mesh.Vertices[c];
          const Id start = this->Children.GetStart(c);
          const Id finish = this->Children.GetEnd(c);
          out.Edges[start] = 2 * edge + (along ? 0 : 1);
          out.Edges[finish] = 2 * edge + (along ? 1 : 0);
          if (twin < 0)
          {
            out.Twins[start] = -1;
            out.Twins[finish] = -1;
            continue;
          }
          const bool sameWay = this->Mesh.Vertices[twin] == this->Mesh.Vertices[c];
          const Id twinStart = this->Children.GetStart(twin);
          const Id twinEnd = this->Children.GetEnd(twin);
          out.Twins[start] = sameWay ? twinStart : twinEnd;
          out.Twins[finish] = sameWay ? twinEnd : twinStart;
        }
      });
    ForEach(this->Mesh.NumberOfVertices,
      [&](vtkIdType v)
      {
        const Id corner = this->Mesh.VertexCorners[v];
        out.VertexCorners[v] = corner < 0 ? corner : this->Children.GetStart(corner);
      });
  }

  void SplitEdgeVertices(PolygonMesh<Id>& out) const
  {
    const Id vertices = static_cast<Id>(this->Mesh.NumberOfVertices);
    ForEach(this->Mesh.GetNumberOfEdges(),
      [&](vtkIdType e)
      {
        out.EdgeVertices[4 * e] = this->Mesh.EdgeVertices[2 * e];
        out.EdgeVertices[4 * e + 1] = vertices + static_cast<Id>(e);
        out.EdgeVertices[4 * e + 2] = vertices + static_cast<Id>(e);
        out.EdgeVertices[4 * e + 3] = this->Mesh.EdgeVertices[2 * e + 1];
      });
  }

  void SplitEdges(PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.GetNumberOfEdges(),
      [&](vtkIdType e)
      {
        const Id corner = this->Mesh.EdgeCorners[e];
        Id& middle = out.VertexCorners[this->Mesh.NumberOfVertices + e];
        if (corner < 0)
        {
          out.EdgeCorners[2 * e] = -1;
          out.EdgeCorners[2 * e + 1] = -1;
          middle = -1; // until SplitJoints
          return;
        }
        const Id start = this->Children.GetStart(corner);
        const Id end = this->Children.GetEnd(corner);
        const bool along = this->Mesh.EdgeVertices[2 * e] == this->Mesh.Vertices[corner];
        out.EdgeCorners[2 * e] = along ? start : end;
        out.EdgeCorners[2 * e + 1] = along ? end : start;
        middle = end;
      });
  }

  /// The children of joints are joints, and the halves of a sheaf are sheaves. The edge points of
  /// sheaves and free edges become joints.
  void SplitJoints(PolygonMesh<Id>& out) const
  {
    std::vector<Id> freeEdges;
    for (const auto& joint : InTurn(this->Mesh.Joints))
    {
      typename PolygonMesh<Id>::Joint child{ joint.Vertex, {}, {} };
      for (Id corner : joint.Fans)
      {
        child.Fans.push_back(this->Children.GetStart(corner));
      }
      for (Id edge : joint.FreeEdges)
      {
        const bool isFirst = this->Mesh.EdgeVertices[2 * edge] == joint.Vertex;
        child.FreeEdges.push_back(2 * edge + (isFirst ? 0 : 1));
        if (isFirst)
        {
          freeEdges.push_back(edge);
        }
      }
      out.Joints.push_back(std::move(child));
    }
    auto addJoint = [&](Id edge, std::vector<Id> fans, std::vector<Id> edges)
    {
      const Id vertex = static_cast<Id>(this->Mesh.NumberOfVertices) + edge;
      out.VertexCorners[vertex] = static_cast<Id>(-2 - static_cast<vtkIdType>(out.Joints.size()));
      out.Joints.push_back({ vertex, std::move(fans), std::move(edges) });
    };
    for (Id edge : InTurn(freeEdges))
    {
      addJoint(edge, {}, { 2 * edge, 2 * edge + 1 });
    }
    for (const auto& sheaf : InTurn(this->Mesh.Sheaves))
    {
      typename PolygonMesh<Id>::Sheaf first{ 2 * sheaf.Edge, {} };
      typename PolygonMesh<Id>::Sheaf second{ 2 * sheaf.Edge + 1, {} };
      std::vector<Id> fans;
      for (Id corner : sheaf.Corners)
      {
        const Id start = this->Children.GetStart(corner);
        const Id end = this->Children.GetEnd(corner);
        const bool along = this->Mesh.EdgeVertices[2 * sheaf.Edge] == this->Mesh.Vertices[corner];
        first.Corners.push_back(along ? start : end);
        second.Corners.push_back(along ? end : start);
        fans.push_back(end);
      }
      addJoint(sheaf.Edge, std::move(fans), {});
      out.Sheaves.push_back(std::move(first));
      out.Sheaves.push_back(std::move(second));
    }
  }

  void SplitLines(Buffer<Id>& lines) const
  {
    lines = Buffer<Id>(2 * this->Level.Lines.size());
    ForEach(this->Level.Lines.size(),
      [&](vtkIdType i)
      {
        const Id edge = this->Level.Lines[i] / 2;
        const Id against = this->Level.Lines[i] % 2;
        lines[2 * i] = 2 * (2 * edge + against) + against;
        lines[2 * i + 1] = 2 * (2 * edge + 1 - against) + against;
      });
  }

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  Split Children;
};

template <typename Id, typename Split>
SurfaceTags<Id> InheritTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags)
{
  const Split children(level.Mesh);
  const vtkIdType vertices = level.Mesh.NumberOfVertices;
  const vtkIdType edges = level.Mesh.GetNumberOfEdges();
  SurfaceTags<Id> out;
  out.Edges = Buffer<EdgeTag>(2 * edges + level.Mesh.GetNumberOfCorners());
  out.Vertices = Buffer<VertexTag>(children.GetNumberOfVertices());
  std::copy(tags.Vertices.begin(), tags.Vertices.end(), out.Vertices.begin());
  ForEach(edges,
    [&](vtkIdType e)
    {
      const EdgeTag tag = tags.Edges[e];
      out.Edges[2 * e] = tag;
      out.Edges[2 * e + 1] = tag;
      out.Vertices[vertices + e] = IsSharp(tag) ? VertexTag::Curve
        : tag == EdgeTag::Blend                 ? VertexTag::Blend
                                                : VertexTag::Smooth;
    });
  std::fill(out.Edges.begin() + 2 * edges, out.Edges.end(), EdgeTag::Smooth);
  std::fill(out.Vertices.begin() + vertices + edges, out.Vertices.end(), VertexTag::Smooth);
  out.Sectors = tags.Sectors;
  for (Sector<Id>& sector : out.Sectors)
  {
    sector.First = children.GetStart(sector.First);
    sector.Last = children.GetStart(sector.Last);
  }
  return out;
}

}

template <typename Id>
SurfaceLevel<Id> RefineTriangles(const SurfaceLevel<Id>& level, Depth depth)
{
  SurfaceLevel<Id> next = PrimalRefiner<Id, TriangleSplit<Id>>(level).Run(depth);
  if (!IsLast(depth))
  {
    next.Tags = RefineTriangleTags(level, level.Tags);
  }
  return next;
}

template <typename Id>
SurfaceLevel<Id> RefineToQuads(const SurfaceLevel<Id>& level, Depth depth)
{
  SurfaceLevel<Id> next = PrimalRefiner<Id, QuadSplit<Id>>(level).Run(depth);
  if (!IsLast(depth))
  {
    next.Tags = RefineToQuadTags(level, level.Tags);
  }
  return next;
}

template <typename Id>
SurfaceTags<Id> RefineTriangleTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags)
{
  return InheritTags<Id, TriangleSplit<Id>>(level, tags);
}

template <typename Id>
SurfaceTags<Id> RefineToQuadTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags)
{
  return InheritTags<Id, QuadSplit<Id>>(level, tags);
}

template <typename Id, typename Out>
void WriteTriangles(const SurfaceLevel<Id>& level, Out* ids)
{
  PrimalRefiner<Id, TriangleSplit<Id>>(level).WriteFaces(ids);
}

template <typename Id, typename Out>
void WriteQuads(const SurfaceLevel<Id>& level, Out* ids)
{
  PrimalRefiner<Id, QuadSplit<Id>>(level).WriteFaces(ids);
}

void ListTriangleChildren(const SurfaceSegments& segments, SurfaceSegments& children)
{
  AppendChildren(segments.Vertices, 1, children.Vertices);
  AppendChildren(segments.Edges, 1, children.Vertices);
  AppendChildren(segments.Edges, 2, children.Edges);
  AppendChildren(segments.Corners, 1, children.Edges);
  AppendChildren(segments.Faces, 4, children.Faces);
  AppendChildren(segments.Faces, 12, children.Corners);
  AppendChildren(segments.Lines, 2, children.Lines);
}

void ListQuadChildren(const SurfaceSegments& segments, SurfaceSegments& children)
{
  AppendChildren(segments.Vertices, 1, children.Vertices);
  AppendChildren(segments.Edges, 1, children.Vertices);
  AppendChildren(segments.Faces, 1, children.Vertices);
  AppendChildren(segments.Edges, 2, children.Edges);
  AppendChildren(segments.Corners, 1, children.Edges);
  AppendChildren(segments.Corners, 1, children.Faces);
  AppendChildren(segments.Corners, 4, children.Corners);
  AppendChildren(segments.Lines, 2, children.Lines);
}

SUBDIVISION_COMPILE_FUNCTION(RefineTriangles);
SUBDIVISION_COMPILE_FUNCTION(RefineToQuads);
SUBDIVISION_COMPILE_FUNCTION(RefineTriangleTags);
SUBDIVISION_COMPILE_FUNCTION(RefineToQuadTags);
SUBDIVISION_COMPILE_WRITER(WriteTriangles);
SUBDIVISION_COMPILE_WRITER(WriteQuads);

}
