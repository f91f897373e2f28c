// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/SqrtThreeRefinement.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Scheme/FixedEdges.h"
#include "Core/Surfaces/Scheme/SplitJoints.h"
#include "Core/Surfaces/Scheme/TurnedSectors.h"

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
    next.VerticesBefore =
      this->Level.VerticesBefore < 0 ? this->Mesh.NumberOfVertices : this->Level.VerticesBefore;
    PolygonMesh<Id>& out = next.Mesh;
    out.Arity = 3;
    out.NumberOfVertices = this->Children.GetNumberOfVertices();
    out.NumberOfFaces = 3 * this->Mesh.NumberOfFaces;
    const vtkIdType corners = 3 * out.NumberOfFaces;
    const vtkIdType edges = this->Children.GetNumberOfEdges();
    const bool isLast = depth == Depth::ForCounts;
    const bool hasEdges = !isLast && (depth == Depth::ForRefinement || this->Children.HasFixed);
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
      out.Vertices = Buffer<Id>(corners);
      this->WriteFaces(out.Vertices.data());
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
      SplitJoints(this->Mesh, PiecesIn{ *this, out }, out);
    }
    next.Lines = SplitLines(this->Level.Lines, PiecesIn{ *this, out });
    return next;
  }

  template <typename Out>
  void WriteFaces(Out* ids) const
  {
    ForEach(this->Mesh.GetNumberOfCorners(),
      [&](vtkIdType c) { this->SetChild(static_cast<Id>(c), ids + 3 * c); });
  }

private:
  /// For SplitJoints.h: the middle third of an edge keeps its number.
  struct PiecesIn
  {
    const SqrtThreeRefiner& Refiner;
    const PolygonMesh<Id>& Out;

    int GetNumberOfPieces() const { return this->Refiner.Children.HasThirds() ? 3 : 1; }
    Id GetPiece(Id edge, int i) const
    {
      const bool isWhole = this->GetNumberOfPieces() == 1 || i == 1;
      return isWhole ? edge : this->Refiner.GetOuter(edge, i / 2);
    }
    Id GetPoint(Id edge, int i) const { return this->Refiner.Children.GetThird(edge) + i; }
    Id GetOnPiece(Id corner, int i) const
    {
      const Id edge = this->Refiner.Mesh.Edges[corner];
      const bool isWhole = this->GetNumberOfPieces() == 1 || i == 1;
      return isWhole
        ? 3 * corner
        : this->Refiner.GetOuterSide(corner, this->Refiner.Mesh.EdgeVertices[2 * edge + i / 2]);
    }
    Id GetCornerAt(Id corner, int i) const { return this->Refiner.GetCornerOfThird(corner, i); }
    Id GetCornerInFan(Id corner) const { return this->Refiner.GetCornerInFan(corner, this->Out); }
  };

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

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  SqrtThreeTopology<Id> Children;
};

}

template <typename Id>
void SqrtThreeRefinement<Id>::Prepare(SurfaceLevel<Id>& level) const
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
SurfaceTags<Id> MakeTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, bool ofEdges)
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
  out.Sectors = tags.Sectors;
  MoveSectors(
    level.Mesh, tags, [&](Id fixed, Id vertex) { return children.GetCornerAtEnd(fixed, vertex); },
    out.Sectors);
  return out;
}

}

template <typename Id>
SurfaceTags<Id> SqrtThreeRefinement<Id>::RefineTags(
  const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const
{
  return MakeTags(level, tags, true);
}

template <typename Id>
SurfaceLevel<Id> SqrtThreeRefinement<Id>::Refine(const SurfaceLevel<Id>& level, Depth depth) const
{
  SurfaceLevel<Id> next = SqrtThreeRefiner<Id>(level).Run(depth);
  if (depth != Depth::ForCounts)
  {
    next.Tags = MakeTags(level, level.Tags, !next.Mesh.EdgeCorners.empty());
  }
  return next;
}

template <typename Id>
void SqrtThreeRefinement<Id>::WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const
{
  std::visit([&](auto* to) { SqrtThreeRefiner<Id>(level).WriteFaces(to); }, ids);
}

template <typename Id>
void SqrtThreeRefinement<Id>::ListChildren(
  const SurfaceLevel<Id>& level, const SurfaceSegments& segments, SurfaceSegments& children) const
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

SUBDIVISION_COMPILE(class SqrtThreeRefinement);

}
