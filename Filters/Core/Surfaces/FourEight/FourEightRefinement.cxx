// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightRefinement.h"

#include "Core/Memory/Ids.h"

namespace subdivision
{
namespace
{

template <typename Id>
class FourEightRefiner : public CentreRefiner<Id, FourEightTopology<Id>, FourEightRefiner<Id>>
{
public:
  using CentreRefiner<Id, FourEightTopology<Id>, FourEightRefiner<Id>>::CentreRefiner;

  void SetCounts(SurfaceLevel<Id>& next, bool isLast) const
  {
    PolygonMesh<Id>& out = next.Mesh;
    out.Arity = this->Children.HasTriangles() ? 0 : 4;
    if (out.Arity == 0)
    {
      out.FaceOffsets = Buffer<Id>(out.NumberOfFaces + 1);
      out.CornerFaces = Buffer<Id>(isLast ? 0 : vtkIdType(this->Children.GetNumberOfCorners()));
      this->SetOffsets(out);
    }
  }

  /// Sets the vertices of the child across the edge ab of a corner: a, the apex of the other face,
  /// b, the apex of this face; at a fixed edge a, b, apex.
  template <typename Out>
  void SetChild(Id corner, Out* ids) const
  {
    if (!this->Children.HasChild(corner))
    {
      return;
    }
    auto write = [child = ids + this->Children.GetStart(corner)](Id vertex) mutable
    { *child++ = static_cast<Out>(vertex); };
    write(this->Mesh.Vertices[corner]);
    if (!this->Children.IsFixed(corner))
    {
      write(this->Children.GetApex(this->Mesh.GetFace(this->Mesh.Twins[corner])));
    }
    write(this->Mesh.Vertices[this->Mesh.Next(corner)]);
    write(this->Children.GetApex(this->Mesh.GetFace(corner)));
  }
  void SetEdgeVertices(PolygonMesh<Id>& out) const
  {
    auto set = [&out](Id edge, Id from, Id to)
    {
      out.EdgeVertices[2 * edge] = from;
      out.EdgeVertices[2 * edge + 1] = to;
    };
    ForEach(this->Mesh.GetNumberOfEdges(),
      [&](vtkIdType e)
      {
        const Id edge = static_cast<Id>(e);
        const Id ends[2] = { this->Mesh.EdgeVertices[2 * e], this->Mesh.EdgeVertices[2 * e + 1] };
        if (this->IsSharp(e) && this->Children.IsEven)
        {
          set(this->Children.GetPiece(edge, 0), ends[0], this->Children.GetFirstPoint(edge));
          set(this->Children.GetPiece(edge, 1), this->Children.GetFirstPoint(edge), ends[1]);
        }
        else if (this->IsSharp(e))
        {
          set(this->Children.GetPiece(edge, 0), ends[0], ends[1]);
        }
      });
    ForEach(this->Mesh.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Id face = static_cast<Id>(f);
        const Id apex = this->Children.GetApex(face);
        this->VisitSpokes(face, [&](Id corner)
          { set(this->Children.GetSpoke(face, corner), apex, this->Mesh.Vertices[corner]); });
      });
  }
  /// Sets the half-edges of the next level that lie inside a face, or on its fixed edges.
  void SetFace(Id face, PolygonMesh<Id>& out) const
  {
    Id before = -1; // the side at the end of the edge before, unless it is not known yet
    this->VisitSpokes(face,
      [&](Id corner)
      {
        const auto sides = this->Children.GetSides(corner);
        const Id a = sides.AtBegin;
        const Id b =
          before < 0 ? this->Children.GetSides(this->Mesh.Previous(corner)).AtEnd : before;
        before = sides.AtEnd;
        out.Twins[a] = b;
        out.Twins[b] = a;
        if (!out.Edges.empty())
        {
          const Id spoke = this->Children.GetSpoke(face, corner);
          out.Edges[a] = spoke;
          out.Edges[b] = spoke;
          out.EdgeCorners[spoke] = std::min(a, b);
        }
      });
    const Id first = this->Mesh.GetFirst(face);
    const Id size = this->Children.HasFixed() ? this->Mesh.GetSize(face) : 0;
    for (Id corner = first; corner < first + size; ++corner)
    {
      for (int end = 0; end < 2 && this->Children.IsFixed(corner); ++end)
      {
        this->SetPiece(corner, end, out);
      }
    }
  }
  /// The half-edge on a fixed edge, or on its half at one end.
  Id GetOnPiece(Id corner, int end) const
  {
    return this->Children.IsEven
      ? this->Children.GetHalf(corner, this->Mesh.EdgeVertices[2 * this->Mesh.Edges[corner] + end])
      : this->Children.GetStart(corner);
  }

private:
  /// Sets where children begin if some are triangles, and on whole levels the face of each corner.
  void SetOffsets(PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.GetNumberOfCorners(),
      [&](vtkIdType c)
      {
        const Id corner = static_cast<Id>(c);
        if (!this->Children.HasChild(corner))
        {
          return;
        }
        const Id start = this->Children.GetStart(corner);
        const Id face = this->Children.GetChild(corner);
        out.FaceOffsets[face] = start;
        if (!out.CornerFaces.empty())
        {
          std::fill_n(
            out.CornerFaces.begin() + start, this->Children.IsFixed(corner) ? 3 : 4, face);
        }
      });
    out.FaceOffsets[out.NumberOfFaces] = this->Children.GetNumberOfCorners();
  }
  /// Calls visit(corner) for each corner of a face that a spoke joins to the apex.
  template <typename Visit>
  void VisitSpokes(Id face, const Visit& visit) const
  {
    if (this->Children.IsCut(face))
    {
      visit(this->Mesh.Previous(this->Children.GetCutCorner(face)));
      return;
    }
    const Id first = this->Mesh.GetFirst(face);
    const Id end = first + this->Mesh.GetSize(face);
    for (Id corner = first; corner < end; ++corner)
    {
      visit(corner);
    }
  }
  void SetPiece(Id corner, int end, PolygonMesh<Id>& out) const
  {
    const Id edge = this->Mesh.Edges[corner];
    const Id twin = this->Mesh.Twins[corner];
    const Id piece = this->Children.GetPiece(edge, end);
    const Id halfEdge = this->GetOnPiece(corner, end);
    out.Edges[halfEdge] = piece;
    out.Twins[halfEdge] = twin < 0 ? -1 : this->GetOnPiece(twin, end);
    if (this->Mesh.EdgeCorners[edge] == corner)
    {
      out.EdgeCorners[piece] = halfEdge;
    }
  }
};

}

template <typename Id>
void FourEightRefinement<Id>::Prepare(SurfaceLevel<Id>& level) const
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const bool isEven = level.Step % 2 == 1;
  const vtkIdType corners = mesh.GetNumberOfCorners();
  auto isFixed = [&](vtkIdType corner) { return IsSharp(level.Tags.Edges[mesh.Edges[corner]]); };
  Buffer<Id> children(corners + 1);
  if (std::none_of(level.Tags.Edges.begin(), level.Tags.Edges.end(), IsSharp))
  {
    ForEach(corners, [&](vtkIdType c) { children[c] = mesh.Twins[c] > c; });
    CountsToOffsets(children);
    level.Places = std::move(children);
    return;
  }
  Buffer<Id> centres(mesh.NumberOfFaces + 1);
  Buffer<Id> fixed(mesh.GetNumberOfEdges() + 1);
  Buffer<Id> starts;
  ForEach(corners, [&](vtkIdType c) { children[c] = isFixed(c) ? !isEven : mesh.Twins[c] > c; });
  ForEach(mesh.NumberOfFaces,
    [&](vtkIdType f)
    {
      centres[f] = 1;
      const vtkIdType first = mesh.GetFirst(static_cast<Id>(f));
      const vtkIdType end = first + mesh.GetSize(static_cast<Id>(f));
      for (vtkIdType c = first; c < end && isEven; ++c)
      {
        centres[f] = isFixed(c) ? 0 : centres[f];
      }
    });
  ForEach(mesh.GetNumberOfEdges(), [&](vtkIdType e) { fixed[e] = IsSharp(level.Tags.Edges[e]); });
  if (!isEven)
  {
    starts = Buffer<Id>(corners + 1);
    ForEach(corners, [&](vtkIdType c) { starts[c] = isFixed(c) ? 3 : 4 * children[c]; });
    CountsToOffsets(starts);
  }
  CountsToOffsets(children);
  CountsToOffsets(centres);
  CountsToOffsets(fixed);
  level.Places = Buffer<Id>(children.size() + centres.size() + fixed.size() + starts.size());
  Id* place = level.Places.begin();
  for (const Buffer<Id>* part : { &children, &centres, &fixed, &starts })
  {
    CopyInThreads(part->data(), part->size(), place);
    place += part->size();
  }
}

template <typename Id>
void FourEightRefinement<Id>::WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const
{
  std::visit([&](auto* to) { FourEightRefiner<Id>(level).WriteFaces(to); }, ids);
}

template <typename Id>
SurfaceLevel<Id> FourEightRefinement<Id>::Refine(const SurfaceLevel<Id>& level, Depth depth) const
{
  return this->RefineBy(FourEightRefiner<Id>(level), level, depth);
}

template <typename Id>
void FourEightRefinement<Id>::ListChildren(
  const SurfaceLevel<Id>& level, const SurfaceSegments& segments, SurfaceSegments& children) const
{
  const FourEightTopology<Id> topology(level);
  const auto append = [&](const IdSegments& parents, const auto& before, IdSegments& list)
  {
    AppendVariedChildren(
      parents, segments.Sizes, [&](vtkIdType i) { return before(static_cast<Id>(i)); }, list);
  };
  const int pieces = topology.IsEven ? 2 : 1;
  const auto countFixed = [&](Id edge) { return topology.CountFixedBefore(edge); };
  AppendChildren(segments.Vertices, 1, children.Vertices);
  append(
    segments.Faces, [&](Id face) { return topology.CountCentresBefore(face); }, children.Vertices);
  if (topology.IsEven)
  {
    append(segments.Edges, countFixed, children.Vertices);
  }
  append(segments.Edges, [&](Id edge) { return pieces * countFixed(edge); }, children.Edges);
  append(
    segments.Faces, [&](Id face)
    { return topology.CountSpokesBefore(face, level.Mesh.GetFirst(face)); }, children.Edges);
  append(segments.Corners, [&](Id corner) { return topology.GetChild(corner); }, children.Faces);
  append(segments.Corners, [&](Id corner) { return topology.GetStart(corner); }, children.Corners);
  AppendChildren(segments.Lines, pieces, children.Lines);
}

SUBDIVISION_COMPILE(class FourEightRefinement);

}
