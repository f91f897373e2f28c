// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/PrimalRefinement.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Scheme/SplitJoints.h"

#include <type_traits>

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
  /// The half-edges across the triangle near each of its corners, as corners of its children, and
  /// their twins, the half-edges of the middle child.
  static constexpr Id Outer[3] = { 1, 5, 6 };
  static constexpr Id Middle[3] = { 11, 9, 10 };

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

  /// The vertices of the children of a triangle with vertices x and edges e. `first`: the point of
  /// edge 0.
  template <typename Out>
  static void SetChildren(const Id* x, const Id* e, Id first, Out* out)
  {
    const Id x01 = first + e[0];
    const Id x12 = first + e[1];
    const Id x02 = first + e[2];
    const Id children[12] = { x[0], x01, x02, x01, x[1], x12, x02, x12, x[2], x01, x12, x02 };
    std::copy(children, children + 12, out);
  }
  template <typename Out>
  void SetVertices(vtkIdType face, Out* out) const
  {
    SetChildren(this->Mesh.Vertices.data() + 3 * face, this->Mesh.Edges.data() + 3 * face,
      static_cast<Id>(this->Mesh.NumberOfVertices), out + 12 * face);
  }
  /// The vertices of the children of the children.
  template <typename Out>
  void SetGrandchildren(vtkIdType face, Out* out) const
  {
    const Id* e = this->Mesh.Edges.data() + 3 * face;
    const vtkIdType edgesOfMesh = this->Mesh.GetNumberOfEdges();
    const Id inside = static_cast<Id>(2 * edgesOfMesh + 3 * face);
    Id x[12];
    SetChildren(
      this->Mesh.Vertices.data() + 3 * face, e, static_cast<Id>(this->Mesh.NumberOfVertices), x);
    Id edges[12];
    for (Id i = 0; i < 3; ++i)
    {
      const Id along = this->Mesh.EdgeVertices[2 * e[i]] == x[4 * i] ? 0 : 1;
      edges[this->GetStart(i)] = 2 * e[i] + along;
      edges[this->GetEnd(i)] = 2 * e[i] + 1 - along;
      edges[Outer[i]] = inside + i;
      edges[Middle[i]] = inside + i;
    }
    for (int child = 0; child < 4; ++child)
    {
      SetChildren(x + 3 * child, edges + 3 * child, static_cast<Id>(this->GetNumberOfVertices()),
        out + 48 * face + 12 * child);
    }
  }

  /// Half-edges inside a face: their edges and twins.
  void SetInside(vtkIdType face, PolygonMesh<Id>& out) const
  {
    const Id first = static_cast<Id>(12 * face);
    const Id* e = this->Mesh.Edges.data() + 3 * face;
    for (int i = 0; i < 3; ++i)
    {
      const Id edge = static_cast<Id>(2 * this->Mesh.GetNumberOfEdges() + 3 * face + i);
      out.Edges[first + Outer[i]] = edge;
      out.Edges[first + Middle[i]] = edge;
      out.Twins[first + Outer[i]] = first + Middle[i];
      out.Twins[first + Middle[i]] = first + Outer[i];
      out.EdgeCorners[edge] = first + Outer[i];
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

  /// The vertices of the children of the children of a quad.
  template <typename Out>
  void SetGrandchildren(vtkIdType face, Out* out) const
  {
    const Id* x = this->Mesh.Vertices.data() + 4 * face;
    const Id* e = this->Mesh.Edges.data() + 4 * face;
    const Id vertices = static_cast<Id>(this->Mesh.NumberOfVertices);
    const Id middle =
      vertices + static_cast<Id>(this->Mesh.GetNumberOfEdges()) + static_cast<Id>(face);
    const Id inside = static_cast<Id>(2 * this->Mesh.GetNumberOfEdges() + 4 * face);
    const Id points = static_cast<Id>(this->GetNumberOfVertices());
    const Id middles = points + 2 * static_cast<Id>(this->Mesh.GetNumberOfEdges()) +
      static_cast<Id>(this->Mesh.GetNumberOfCorners() + 4 * face);
    Id halves[4][2]; // of each edge: that which begins at the corner, and the other
    for (int i = 0; i < 4; ++i)
    {
      const Id along = this->Mesh.EdgeVertices[2 * e[i]] == x[i] ? 0 : 1;
      halves[i][0] = points + 2 * e[i] + along;
      halves[i][1] = points + 2 * e[i] + 1 - along;
    }
    Out* quads = out + 64 * face;
    for (int i = 0; i < 4; ++i, quads += 16)
    {
      const int before = (i + 3) % 4;
      const Id corners[4] = { x[i], vertices + e[i], middle, vertices + e[before] };
      const Id edges[4] = { halves[i][0], points + inside + i, points + inside + before,
        halves[before][1] };
      for (int k = 0; k < 4; ++k)
      {
        quads[4 * k] = corners[k];
        quads[4 * k + 1] = edges[k];
        quads[4 * k + 2] = middles + i;
        quads[4 * k + 3] = edges[(k + 3) % 4];
      }
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
    const bool isWhole = depth != Depth::ForCounts;
    out.EdgesNotStored = isWhole ? 0 : edges;
    if (isWhole || !this->Level.Lines.empty())
    {
      out.EdgeVertices = Buffer<Id>(2 * edges);
      this->SplitEdgeVertices(out);
    }
    if (isWhole)
    {
      out.Vertices = Buffer<Id>(corners);
      out.Edges = Buffer<Id>(corners);
      out.Twins = Buffer<Id>(corners);
      out.EdgeCorners = Buffer<Id>(edges);
      out.VertexCorners = Buffer<Id>(out.NumberOfVertices);
      this->SplitFaces(out);
      this->SplitEdges(out);
      SplitJoints(this->Mesh, *this, out);
    }
    next.Lines = SplitLines(this->Level.Lines, *this);
    return next;
  }

  // For SplitJoints.h.
  int GetNumberOfPieces() const { return 2; }
  Id GetPiece(Id edge, int i) const { return 2 * edge + i; }
  Id GetPoint(Id edge, int) const { return static_cast<Id>(this->Mesh.NumberOfVertices) + edge; }
  Id GetOnPiece(Id corner, int i) const
  {
    const Id edge = this->Mesh.Edges[corner];
    const bool isStart = this->Mesh.EdgeVertices[2 * edge + i] == this->Mesh.Vertices[corner];
    return isStart ? this->Children.GetStart(corner) : this->Children.GetEnd(corner);
  }
  Id GetCornerAt(Id corner, int) const { return this->Children.GetEnd(corner); }
  Id GetCornerInFan(Id corner) const { return this->Children.GetStart(corner); }

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

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  Split Children;
};

template <typename Id, int Arity>
using Split = std::conditional_t<Arity == 3, TriangleSplit<Id>, QuadSplit<Id>>;

/// The corner before another, where all faces have Arity corners.
template <int Arity>
vtkIdType GetPrevious(vtkIdType corner)
{
  return corner % Arity == 0 ? corner + Arity - 1 : corner - 1;
}

}

template <typename Id, int Arity>
void PrimalScheme<Id, Arity>::GetParents(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType edge = row - mesh.NumberOfVertices;
  const vtkIdType face = edge - mesh.GetNumberOfEdges();
  if (edge < 0)
  {
    parents.assign({ row });
  }
  else if (face < 0)
  {
    parents.assign({ mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] });
  }
  else
  {
    const Id* first = mesh.Vertices.data() + mesh.GetFirst(static_cast<Id>(face));
    parents.assign(first, first + mesh.GetSize(static_cast<Id>(face)));
  }
}

template <typename Id, int Arity>
void PrimalScheme<Id, Arity>::GetParentsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType edgePoints = mesh.NumberOfVertices;
  const vtkIdType facePoints = edgePoints + mesh.GetNumberOfEdges();
  const vtkIdType half = row - this->GetNumberOfRows(level);
  const vtkIdType inside = half - 2 * mesh.GetNumberOfEdges();
  const vtkIdType child = inside - mesh.GetNumberOfCorners();
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
    parents.assign({ edgePoints + mesh.Edges[inside],
      Arity == 3 ? edgePoints + mesh.Edges[GetPrevious<Arity>(inside)] : facePoints + inside / 4 });
  }
  else
  {
    parents.assign({ mesh.Vertices[child], edgePoints + mesh.Edges[child], facePoints + child / 4,
      edgePoints + mesh.Edges[GetPrevious<Arity>(child)] });
  }
}

template <typename Id, int Arity>
SurfaceLevel<Id> PrimalScheme<Id, Arity>::Refine(const SurfaceLevel<Id>& level, Depth depth) const
{
  SurfaceLevel<Id> next = PrimalRefiner<Id, Split<Id, Arity>>(level).Run(depth);
  if (depth != Depth::ForCounts)
  {
    next.Tags = this->RefineTags(level, level.Tags);
  }
  return next;
}

template <typename Id, int Arity>
void PrimalScheme<Id, Arity>::ListChildren(
  const SurfaceLevel<Id>&, const SurfaceSegments& segments, SurfaceSegments& children) const
{
  constexpr bool areQuads = Arity == 4;
  AppendChildren(segments.Vertices, 1, children.Vertices);
  AppendChildren(segments.Edges, 1, children.Vertices);
  if (areQuads)
  {
    AppendChildren(segments.Faces, 1, children.Vertices);
  }
  AppendChildren(segments.Edges, 2, children.Edges);
  AppendChildren(segments.Corners, 1, children.Edges);
  const IdSegments& parents = areQuads ? segments.Corners : segments.Faces;
  AppendChildren(parents, areQuads ? 1 : 4, children.Faces);
  AppendChildren(parents, areQuads ? 4 : 12, children.Corners);
  AppendChildren(segments.Lines, 2, children.Lines);
}

template <typename Id, int Arity>
void PrimalScheme<Id, Arity>::WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const
{
  const Split<Id, Arity> split(level.Mesh);
  std::visit([&](auto* to)
    { ForEach(level.Mesh.NumberOfFaces, [&](vtkIdType f) { split.SetVertices(f, to); }); }, ids);
}

template <typename Id, int Arity>
void PrimalScheme<Id, Arity>::WriteFacesOfNext(const SurfaceLevel<Id>& level, IdsOut ids) const
{
  const Split<Id, Arity> split(level.Mesh);
  std::visit([&](auto* to)
    { ForEach(level.Mesh.NumberOfFaces, [&](vtkIdType f) { split.SetGrandchildren(f, to); }); },
    ids);
}

template <typename Id, int Arity>
SurfaceTags<Id> PrimalScheme<Id, Arity>::RefineTags(
  const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const
{
  const Split<Id, Arity> children(level.Mesh);
  const vtkIdType vertices = level.Mesh.NumberOfVertices;
  const vtkIdType edges = level.Mesh.GetNumberOfEdges();
  SurfaceTags<Id> out;
  out.Edges = Buffer<EdgeTag>(2 * edges + level.Mesh.GetNumberOfCorners());
  out.Vertices = Buffer<VertexTag>(this->GetNumberOfRows(level));
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

template <typename Id, int Arity>
void PrimalScheme<Id, Arity>::CarryFaces(const SurfaceLevel<Id>& level,
  const Buffer<Carrier<Id>>& faces, bool, Buffer<Carrier<Id>>& children) const
{
  children = Buffer<Carrier<Id>>(Split<Id, Arity>(level.Mesh).GetNumberOfFaces());
  ForEach(children.size(),
    [&](vtkIdType i) { children[i] = faces[PrimalScheme::GetOrientingFace(level, i)]; });
}

template class PrimalScheme<int, 3>;
template class PrimalScheme<int, 4>;
template class PrimalScheme<long long, 3>;
template class PrimalScheme<long long, 4>;

}
