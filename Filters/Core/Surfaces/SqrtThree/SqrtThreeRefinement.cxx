// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/SqrtThreeRefinement.h"

#include "Core/Memory/Ids.h"

namespace subdivision
{
namespace
{

template <typename Id>
class SqrtThreeRefiner : public CentreRefiner<Id, SqrtThreeTopology<Id>, SqrtThreeRefiner<Id>>
{
public:
  using CentreRefiner<Id, SqrtThreeTopology<Id>, SqrtThreeRefiner<Id>>::CentreRefiner;

  void SetCounts(SurfaceLevel<Id>& next, bool) const
  {
    next.VerticesBefore =
      this->Level.VerticesBefore < 0 ? this->Mesh.NumberOfVertices : this->Level.VerticesBefore;
    next.Mesh.Arity = 3;
  }

  /// The child across the edge of a corner.
  template <typename Out>
  void SetChild(Id corner, Out* ids) const
  {
    Out* child = ids + 3 * vtkIdType(corner);
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

  void SetFace(Id face, PolygonMesh<Id>& out) const
  {
    if (out.Edges.empty())
    {
      this->SetTwins(face, out);
      return;
    }
    this->SetAcross(face, out);
    this->SetInside(face, out);
  }
  Id GetOnPiece(Id corner, int i) const
  {
    const bool isWhole = !this->Children.HasThirds() || i == 1;
    return isWhole
      ? 3 * corner
      : this->GetOuterSide(corner, this->Mesh.EdgeVertices[2 * this->Mesh.Edges[corner] + i / 2]);
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
          ends[0] = this->Children.GetFirstPoint(edge);
          ends[1] = ends[0] + 1;
          Id* outer = out.EdgeVertices.data() + 2 * this->Children.GetPiece(edge, 0);
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

private:
  bool IsCut(Id corner) const { return this->Children.HasThirds() && this->IsFixed(corner); }
  bool IsFixed(Id corner) const { return this->Children.IsFixed(corner); }
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

template <typename Id>
SurfaceLevel<Id> SqrtThreeRefinement<Id>::Refine(const SurfaceLevel<Id>& level, Depth depth) const
{
  return this->RefineBy(SqrtThreeRefiner<Id>(level), level, depth);
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
