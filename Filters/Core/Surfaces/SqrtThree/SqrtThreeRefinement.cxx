// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/SqrtThreeRefinement.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Scheme/FixedEdges.h"

namespace subdivision
{
namespace
{

template <typename Id>
class SqrtThreeRefiner
{
public:
  explicit SqrtThreeRefiner(const SurfaceLevel<Id>& level)
    : Level(level)
    , Mesh(level.Mesh)
    , Children(level)
  {
  }

  SurfaceLevel<Id> Run(Depth depth)
  {
    SurfaceLevel<Id> next;
    next.Step = this->Level.Step + 1;
    next.FirstMade =
      this->Level.FirstMade < 0 ? this->Mesh.NumberOfVertices : this->Level.FirstMade;
    PolygonMesh<Id>& out = next.Mesh;
    out.Arity = 3;
    out.NumberOfVertices = this->Children.GetNumberOfVertices();
    out.NumberOfFaces = 3 * this->Mesh.NumberOfFaces;
    const vtkIdType corners = 3 * out.NumberOfFaces;
    const vtkIdType edges = this->Children.GetNumberOfEdges();
    const bool isLast = IsLast(depth);
    const bool hasEdges = !isLast && (depth == Depth::ForRefinement || this->Children.HasFixed);
    if (depth != Depth::ForCounts)
    {
      out.Vertices = Buffer<Id>(corners);
      this->WriteFaces(out.Vertices.data());
    }
    out.EdgesNotStored = hasEdges ? 0 : edges;
    if (hasEdges || !this->Level.Lines.empty())
    {
      out.EdgeVertices = Buffer<Id>(2 * edges);
      this->SetEdgeVertices(out);
    }
    if (hasEdges)
    {
      out.Edges = Buffer<Id>(corners);
      out.EdgeCorners = Buffer<Id>(edges);
      this->SetFreeEdges(out);
    }
    if (!isLast)
    {
      out.Twins = Buffer<Id>(corners);
      out.VertexCorners = Buffer<Id>(out.NumberOfVertices);
      ForEach(this->Mesh.NumberOfFaces,
        [&](vtkIdType f)
        {
          const Id face = static_cast<Id>(f);
          if (hasEdges)
          {
            this->SetAcross(face, out);
            this->SetInside(face, out);
          }
          else
          {
            this->SetTwins(face, out);
          }
        });
      this->SetVertexCorners(out);
      this->SplitJoints(out);
    }
    this->SplitLines(next.Lines);
    return next;
  }

  template <typename Out>
  void WriteFaces(Out* ids) const
  {
    ForEach(this->Mesh.GetNumberOfCorners(),
      [&](vtkIdType c) { this->SetChild(static_cast<Id>(c), ids + 3 * c); });
  }

private:
  using Joint = typename PolygonMesh<Id>::Joint;
  using Sheaf = typename PolygonMesh<Id>::Sheaf;

  bool IsCut(Id corner) const { return this->Children.HasThirds() && this->IsFixed(corner); }
  bool IsFixed(Id corner) const { return this->Children.IsFixed(corner); }
  bool RunsAlong(Id corner) const
  {
    return this->Mesh.EdgeVertices[2 * this->Mesh.Edges[corner]] == this->Mesh.Vertices[corner];
  }
  bool IsSharp(vtkIdType edge) const { return subdivision::IsSharp(this->Level.Tags.Edges[edge]); }

  /// The child across the edge of a corner.
  template <typename Out>
  void SetChild(Id corner, Out* child) const
  {
    const Id next = this->Mesh.Next(corner);
    const Id a = this->Mesh.Vertices[corner];
    const Id b = this->Mesh.Vertices[next];
    if (this->IsCut(corner))
    {
      const Id edge = this->Mesh.Edges[corner];
      child[0] = this->Children.GetThirdNear(edge, a);
      child[1] = this->Children.GetThirdNear(edge, b);
      child[2] = this->Mesh.Vertices[this->Mesh.Next(next)];
      return;
    }
    if (this->IsFixed(corner))
    {
      child[0] = a;
      child[1] = b;
      child[2] = this->Children.GetCentre(corner / 3);
      return;
    }
    const Id twin = this->Mesh.Twins[corner];
    const bool isSecond = this->Children.RunsWith(corner, twin) && twin < corner;
    const Id own = this->Children.GetApex(corner);
    const Id other = this->Children.GetApex(twin);
    child[0] = isSecond ? b : a;
    child[1] = isSecond ? own : other;
    child[2] = isSecond ? other : own;
  }

  /// Sets the half-edges of the next level that are not inside a face: on flipped edges, between
  /// two apexes, and on fixed edges or their middle thirds.
  void SetAcross(Id face, PolygonMesh<Id>& out) const
  {
    for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
    {
      const Id edge = this->Mesh.Edges[corner];
      const Id twin = this->Mesh.Twins[corner];
      const Id side = this->IsFixed(corner) ? 0 : 1;
      out.Edges[3 * corner + side] = edge;
      out.Twins[3 * corner + side] = twin < 0 ? -1 : 3 * twin + side;
      if (this->Mesh.EdgeCorners[edge] == corner)
      {
        out.EdgeCorners[edge] = 3 * corner + side;
      }
    }
  }

  /// Sets the twins only, which is all that further steps read if no edge is fixed.
  void SetTwins(Id face, PolygonMesh<Id>& out) const
  {
    for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
    {
      out.Twins[3 * corner + 1] = 3 * this->Mesh.Twins[corner] + 1;
      const Id a = this->Children.GetSideAtBegin(corner);
      const Id b = this->Children.GetSideAtEnd(this->Mesh.Previous(corner));
      out.Twins[a] = b;
      out.Twins[b] = a;
    }
  }

  /// Joins two half-edges inside a face to an edge of the next level.
  void Join(Id a, Id b, Id edge, PolygonMesh<Id>& out) const
  {
    out.Edges[a] = edge;
    out.Edges[b] = edge;
    out.Twins[a] = b;
    out.Twins[b] = a;
    out.EdgeCorners[edge] = std::min(a, b);
  }
  void SetInside(Id face, PolygonMesh<Id>& out) const
  {
    if (this->Children.GetCentre(face) >= 0)
    {
      for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
      {
        this->Join(this->Children.GetSideAtBegin(corner),
          this->Children.GetSideAtEnd(this->Mesh.Previous(corner)),
          this->Children.GetSpokeAtBegin(corner), out);
      }
      return;
    }
    const Id cut = this->Children.GetCutCorner(face);
    this->Join(3 * cut + 2, this->Children.GetSideAtBegin(this->Mesh.Previous(cut)),
      this->Children.GetCutSpoke(cut, false), out);
    this->Join(3 * cut + 1, this->Children.GetSideAtEnd(this->Mesh.Next(cut)),
      this->Children.GetCutSpoke(cut, true), out);
    const Id ends[2] = { cut, this->Mesh.Next(cut) };
    for (int i = 0; i < 2; ++i)
    {
      const Id vertex = this->Mesh.Vertices[ends[i]];
      const Id side = this->GetOuterSide(cut, vertex);
      const Id twin = this->Mesh.Twins[cut];
      const Id edge = this->Children.GetOuterEdge(this->Mesh.Edges[cut], vertex);
      out.Edges[side] = edge;
      out.Twins[side] = twin < 0 ? -1 : this->GetOuterSide(twin, vertex);
      if (this->Mesh.EdgeCorners[this->Mesh.Edges[cut]] == cut)
      {
        out.EdgeCorners[edge] = side;
      }
    }
  }
  Id GetOuterSide(Id cut, Id vertex) const
  {
    return this->Mesh.Vertices[cut] == vertex ? this->Children.GetOuterSideAtBegin(cut)
                                              : this->Children.GetOuterSideAtEnd(cut);
  }

  void SetFreeEdges(PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.GetNumberOfEdges(),
      [&](vtkIdType e)
      {
        if (this->Mesh.EdgeCorners[e] < 0)
        {
          out.EdgeCorners[e] = -1;
          for (int i = 0; i < 2 && this->Children.HasThirds(); ++i)
          {
            out.EdgeCorners[this->GetOuter(static_cast<Id>(e), i)] = -1;
          }
        }
      });
  }
  /// The outer third of an edge at one of its ends.
  Id GetOuter(Id edge, int end) const
  {
    return this->Children.GetOuterEdge(edge, this->Mesh.EdgeVertices[2 * edge + end]);
  }

  void SetEdgeVertices(PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.GetNumberOfEdges(),
      [&](vtkIdType e)
      {
        const Id edge = static_cast<Id>(e);
        const Id* old = this->Mesh.EdgeVertices.data() + 2 * e;
        Id* ends = out.EdgeVertices.data() + 2 * e;
        if (!this->IsSharp(e))
        {
          const Id corner = this->Mesh.EdgeCorners[e];
          ends[0] = this->Children.GetApex(corner);
          ends[1] = this->Children.GetApex(this->Mesh.Twins[corner]);
        }
        else if (this->Children.HasThirds())
        {
          ends[0] = this->Children.GetThird(edge);
          ends[1] = ends[0] + 1;
          Id* outer = out.EdgeVertices.data() + 2 * this->GetOuter(edge, 0);
          const Id pieces[4] = { old[0], ends[0], ends[1], old[1] };
          std::copy(pieces, pieces + 4, outer);
        }
        else
        {
          std::copy(old, old + 2, ends);
        }
      });
    ForEach(this->Mesh.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Id face = static_cast<Id>(f);
        const Id centre = this->Children.GetCentre(face);
        auto set = [&out](Id spoke, Id from, Id to)
        {
          out.EdgeVertices[2 * spoke] = from;
          out.EdgeVertices[2 * spoke + 1] = to;
        };
        if (centre >= 0)
        {
          for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
          {
            set(this->Children.GetSpokeAtBegin(corner), centre, this->Mesh.Vertices[corner]);
          }
          return;
        }
        const Id cut = this->Children.GetCutCorner(face);
        const Id apex = this->Mesh.Vertices[this->Mesh.Previous(cut)];
        const Id edge = this->Mesh.Edges[cut];
        for (const bool atEnd : { false, true })
        {
          const Id end = this->Mesh.Vertices[atEnd ? this->Mesh.Next(cut) : cut];
          set(this->Children.GetCutSpoke(cut, atEnd), this->Children.GetThirdNear(edge, end), apex);
        }
      });
  }

  /// A corner of the next level at the vertex of an old corner, in the same fan.
  Id GetCornerInFan(Id corner, const PolygonMesh<Id>& out) const
  {
    const Id side = this->Children.GetSideOfCorner(corner);
    return out.Vertices[side] == this->Mesh.Vertices[corner] ? side : out.Next(side);
  }

  void SetVertexCorners(PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.NumberOfVertices,
      [&](vtkIdType v)
      {
        const Id corner = this->Mesh.VertexCorners[v];
        out.VertexCorners[v] = corner < 0 ? corner : this->GetCornerInFan(corner, out);
      });
    ForEach(this->Mesh.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Id centre = this->Children.GetCentre(static_cast<Id>(f));
        if (centre >= 0)
        {
          const Id side = this->Children.GetSideAtBegin(static_cast<Id>(3 * f));
          out.VertexCorners[centre] = out.Vertices[side] == centre ? side : out.Next(side);
        }
      });
    ForEach(this->Children.HasThirds() ? this->Mesh.GetNumberOfEdges() : 0,
      [&](vtkIdType e)
      {
        const Id corner = this->Mesh.EdgeCorners[e];
        if (this->IsSharp(e))
        {
          for (int i = 0; i < 2; ++i) // -1 for free edges until SplitJoints
          {
            out.VertexCorners[this->Children.GetThird(static_cast<Id>(e)) + i] =
              corner < 0 ? -1 : this->GetCornerOfThird(corner, i);
          }
        }
      });
  }
  Id GetCornerOfThird(Id cut, int third) const
  {
    return 3 * cut + (this->RunsAlong(cut) ? third : 1 - third);
  }

  /// The children of joints are joints, and sheaves or their thirds are sheaves. In even steps the
  /// points that cut sheaves and free edges become joints.
  void SplitJoints(PolygonMesh<Id>& out) const
  {
    const bool cuts = this->Children.HasThirds();
    std::vector<Id> freeEdges;
    for (const Joint& joint : this->Mesh.Joints)
    {
      Joint child{ joint.Vertex, {}, {} };
      for (Id corner : joint.Fans)
      {
        child.Fans.push_back(this->GetCornerInFan(corner, out));
      }
      for (Id edge : joint.FreeEdges)
      {
        child.FreeEdges.push_back(cuts ? this->Children.GetOuterEdge(edge, joint.Vertex) : edge);
        if (this->Mesh.EdgeVertices[2 * edge] == joint.Vertex)
        {
          freeEdges.push_back(edge);
        }
      }
      out.Joints.push_back(std::move(child));
    }
    auto addJoint = [&](Id edge, int third, std::vector<Id> fans, std::vector<Id> edges)
    {
      const Id vertex = this->Children.GetThird(edge) + third;
      out.VertexCorners[vertex] = static_cast<Id>(-2 - static_cast<vtkIdType>(out.Joints.size()));
      out.Joints.push_back({ vertex, std::move(fans), std::move(edges) });
    };
    for (int i = 0; i < 2 && cuts; ++i)
    {
      for (Id edge : freeEdges)
      {
        addJoint(edge, i, {}, { edge, this->GetOuter(edge, i) });
      }
      for (const Sheaf& sheaf : this->Mesh.Sheaves)
      {
        Sheaf outer{ this->GetOuter(sheaf.Edge, i), {} };
        std::vector<Id> fans;
        for (Id corner : sheaf.Corners)
        {
          const Id vertex = this->Mesh.EdgeVertices[2 * sheaf.Edge + i];
          outer.Corners.push_back(this->GetOuterSide(corner, vertex));
          fans.push_back(this->GetCornerOfThird(corner, i));
        }
        addJoint(sheaf.Edge, i, std::move(fans), {});
        out.Sheaves.push_back(std::move(outer));
      }
    }
    for (const Sheaf& sheaf : this->Mesh.Sheaves)
    {
      Sheaf child{ sheaf.Edge, {} };
      for (Id corner : sheaf.Corners)
      {
        child.Corners.push_back(3 * corner);
      }
      out.Sheaves.push_back(std::move(child));
    }
    std::sort(out.Sheaves.begin(), out.Sheaves.end(),
      [](const Sheaf& a, const Sheaf& b) { return b.Edge > a.Edge; });
  }

  void SplitLines(Buffer<Id>& lines) const
  {
    const Buffer<Id>& old = this->Level.Lines;
    const bool cuts = this->Children.HasThirds();
    lines = Buffer<Id>(cuts ? 3 * old.size() : old.size());
    ForEach(old.size(),
      [&](vtkIdType i)
      {
        if (!cuts)
        {
          lines[i] = old[i];
          return;
        }
        const Id edge = old[i] / 2;
        const Id against = old[i] % 2;
        lines[3 * i] = 2 * this->GetOuter(edge, against) + against;
        lines[3 * i + 1] = old[i];
        lines[3 * i + 2] = 2 * this->GetOuter(edge, 1 - against) + against;
      });
  }

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  SqrtThreeTopology<Id> Children;
};

}

template <typename Id>
void CountSqrtThreePlaces(SurfaceLevel<Id>& level)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Buffer<EdgeTag>& tags = level.Tags.Edges;
  level.HasCurves = HasSharpEdges(level.Tags);
  if (level.Step % 2 == 0 || !level.HasCurves)
  {
    return;
  }
  // After an odd step each triangle has at most one fixed edge.
  Buffer<signed char> cuts(mesh.NumberOfFaces);
  Buffer<Id> centres(mesh.NumberOfFaces + 1);
  Buffer<Id> thirds(mesh.GetNumberOfEdges() + 1);
  ForEach(mesh.NumberOfFaces,
    [&](vtkIdType f)
    {
      cuts[f] = -1;
      for (int i = 0; i < 3; ++i)
      {
        cuts[f] = IsSharp(tags[mesh.Edges[3 * f + i]]) ? static_cast<signed char>(i) : cuts[f];
      }
      centres[f] = cuts[f] < 0 ? 1 : 0;
    });
  ForEach(mesh.GetNumberOfEdges(), [&](vtkIdType e) { thirds[e] = IsSharp(tags[e]) ? 1 : 0; });
  CountsToOffsets(centres);
  CountsToOffsets(thirds);
  const Id vertices = static_cast<Id>(mesh.NumberOfVertices);
  const Id all = centres[mesh.NumberOfFaces];
  level.Places = Buffer<Id>(mesh.NumberOfFaces + mesh.GetNumberOfEdges() + 2);
  ForEach(mesh.NumberOfFaces, [&](vtkIdType f)
    { level.Places[f] = cuts[f] < 0 ? vertices + centres[f] : -1 - (3 * centres[f] + cuts[f]); });
  Id* places = level.Places.data() + mesh.NumberOfFaces;
  ForEach(
    mesh.GetNumberOfEdges(), [&](vtkIdType e) { places[e] = vertices + all + 2 * thirds[e]; });
  places[mesh.GetNumberOfEdges()] = all;
  places[mesh.GetNumberOfEdges() + 1] = thirds[mesh.GetNumberOfEdges()];
}

namespace
{

/// `ofEdges`: the tags of edges too.
template <typename Id>
SurfaceTags<Id> RefineTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, bool ofEdges)
{
  const SqrtThreeTopology<Id> children(level);
  const vtkIdType edges = level.Mesh.GetNumberOfEdges();
  const vtkIdType centres = level.Mesh.NumberOfVertices + children.Centres;
  SurfaceTags<Id> out;
  out.Edges = Buffer<EdgeTag>(ofEdges ? children.GetNumberOfEdges() : 0);
  out.Vertices = Buffer<VertexTag>(children.GetNumberOfVertices());
  ForEach(out.Edges.size(),
    [&](vtkIdType e)
    {
      out.Edges[e] = e < edges            ? tags.Edges[e]
        : e < edges + 2 * children.Thirds ? EdgeTag::Sharp
                                          : EdgeTag::Smooth;
    });
  ForEach(out.Vertices.size(),
    [&](vtkIdType v)
    {
      out.Vertices[v] = v < level.Mesh.NumberOfVertices ? tags.Vertices[v]
        : v < centres                                   ? VertexTag::Smooth
                                                        : VertexTag::Curve;
    });
  out.Sectors = tags.Sectors; // their corners are corners of the control level
  return out;
}

}

template <typename Id>
SurfaceTags<Id> RefineSqrtThreeTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags)
{
  return RefineTags(level, tags, true);
}

template <typename Id>
SurfaceLevel<Id> RefineSqrtThree(const SurfaceLevel<Id>& level, Depth depth)
{
  SurfaceLevel<Id> next = SqrtThreeRefiner<Id>(level).Run(depth);
  if (!IsLast(depth))
  {
    next.Tags = RefineTags(level, level.Tags, !next.Mesh.EdgeCorners.empty());
  }
  return next;
}

template <typename Id>
void WriteSqrtThree(const SurfaceLevel<Id>& level, IdsOut ids)
{
  std::visit([&](auto* to) { SqrtThreeRefiner<Id>(level).WriteFaces(to); }, ids);
}

template <typename Id>
void ListSqrtThreeChildren(
  const SurfaceLevel<Id>& level, const SurfaceSegments& segments, SurfaceSegments& children)
{
  const SqrtThreeTopology<Id> topology(level);
  const auto append = [&](const IdSegments& parents, const auto& before, IdSegments& list)
  {
    AppendVariedChildren(
      parents, segments.Sizes, [&](vtkIdType i) { return before(static_cast<Id>(i)); }, list);
  };
  AppendChildren(segments.Vertices, 1, children.Vertices);
  AppendChildren(segments.Edges, 1, children.Edges);
  if (topology.IsEven)
  {
    const auto countThirds = [&](Id edge) { return 2 * topology.CountThirdsBefore(edge); };
    append(
      segments.Faces, [&](Id face) { return topology.CountCentresBefore(face); },
      children.Vertices);
    append(segments.Edges, countThirds, children.Vertices);
    append(segments.Edges, countThirds, children.Edges);
    append(
      segments.Faces, [&](Id face) { return 2 * face + topology.CountCentresBefore(face); },
      children.Edges);
  }
  else
  {
    AppendChildren(segments.Faces, 1, children.Vertices);
    AppendChildren(segments.Faces, 3, children.Edges);
  }
  AppendChildren(segments.Faces, 3, children.Faces);
  AppendChildren(segments.Faces, 9, children.Corners);
  AppendChildren(segments.Lines, topology.IsEven ? 3 : 1, children.Lines);
}

SUBDIVISION_COMPILE_FUNCTION(WriteSqrtThree);
SUBDIVISION_COMPILE_FUNCTION(CountSqrtThreePlaces);
SUBDIVISION_COMPILE_FUNCTION(ListSqrtThreeChildren);
SUBDIVISION_COMPILE_FUNCTION(RefineSqrtThree);
SUBDIVISION_COMPILE_FUNCTION(RefineSqrtThreeTags);

}
