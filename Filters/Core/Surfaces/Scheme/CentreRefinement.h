// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CentreRefinement.h
 * The common part of the steps of 4-8 and sqrt(3). A step gives each face a centre, old vertices
 * stay, and edges are replaced unless they are fixed (FixedEdges.h). In even steps the *cut* faces,
 * which have a fixed edge, get no centre, and points cut that edge into pieces.
 *
 * `Topology` knows the ids of children: vertices are old ones, centres and points on edges.
 */
#ifndef SubdivisionObjects_CentreRefinement_h
#define SubdivisionObjects_CentreRefinement_h

#include "Core/Surfaces/Scheme/FixedEdges.h"
#include "Core/Surfaces/Scheme/SplitJoints.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"
#include "Core/Surfaces/Scheme/TurnedSectors.h"

namespace subdivision
{

/**
 * Makes the next level. `Own`, which derives from it, has
 *  - SetCounts(next, isLast): what the scheme adds to the counts of the next level;
 *  - SetEdgeVertices(mesh), SetFace(face, mesh): edges, and the half-edges at the children of a
 *    face, of which `mesh` stores the edges or not;
 *  - SetChild(corner, ids): the vertices of the child across the edge of a corner; `ids` are those
 *    of all children;
 *  - GetOnPiece(corner, i), as in SplitJoints.h.
 */
template <typename Id, typename Topology, typename Own>
class CentreRefiner
{
public:
  explicit CentreRefiner(const SurfaceLevel<Id>& level)
    : Level(level)
    , Mesh(level.Mesh)
    , Children(level)
  {
  }

  SurfaceLevel<Id> Run(Depth depth) const
  {
    const Own& own = static_cast<const Own&>(*this);
    SurfaceLevel<Id> next;
    next.Step = this->Level.Step + 1;
    PolygonMesh<Id>& out = next.Mesh;
    const Pieces pieces{ own, out };
    const bool isLast = depth == Depth::ForCounts;
    const bool hasEdges = !isLast && (depth == Depth::ForRefinement || this->Children.HasFixed());
    const vtkIdType corners = this->Children.GetNumberOfCorners();
    const vtkIdType edges = this->Children.GetNumberOfEdges();
    out.NumberOfVertices = this->Children.GetNumberOfVertices();
    out.NumberOfFaces = this->Children.GetNumberOfFaces();
    own.SetCounts(next, isLast);
    out.EdgesNotStored = hasEdges ? 0 : edges;
    if (hasEdges || !this->Level.Lines.empty())
    {
      out.EdgeVertices = Buffer<Id>(2 * edges);
      own.SetEdgeVertices(out);
    }
    if (hasEdges)
    {
      out.Edges = Buffer<Id>(corners);
      out.EdgeCorners = Buffer<Id>(edges);
      this->SetFreeEdges(pieces, out);
    }
    if (!isLast)
    {
      out.Vertices = Buffer<Id>(corners);
      this->WriteFaces(out.Vertices.data());
      out.Twins = Buffer<Id>(corners);
      out.VertexCorners = Buffer<Id>(out.NumberOfVertices);
      ForEach(this->Mesh.NumberOfFaces, [&](vtkIdType f) { own.SetFace(static_cast<Id>(f), out); });
      this->SetVertexCorners(pieces, out);
      SplitJoints(this->Mesh, pieces, out);
    }
    next.Lines = SplitLines(this->Level.Lines, pieces);
    return next;
  }

  template <typename Out>
  void WriteFaces(Out* ids) const
  {
    ForEach(this->Mesh.GetNumberOfCorners(),
      [&](vtkIdType c) { static_cast<const Own*>(this)->SetChild(static_cast<Id>(c), ids); });
  }

protected:
  bool IsSharp(vtkIdType edge) const { return subdivision::IsSharp(this->Level.Tags.Edges[edge]); }

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  const Topology Children;

private:
  /// For SplitJoints.h.
  struct Pieces
  {
    const Own& Refiner;
    const PolygonMesh<Id>& Out;

    int GetNumberOfPieces() const { return this->Refiner.Children.GetPiecesOfFixed(); }
    Id GetPiece(Id edge, int i) const { return this->Refiner.Children.GetPiece(edge, i); }
    Id GetPoint(Id edge, int i) const { return this->Refiner.Children.GetFirstPoint(edge) + i; }
    Id GetOnPiece(Id corner, int i) const { return this->Refiner.GetOnPiece(corner, i); }
    Id GetCornerAt(Id corner, int i) const
    {
      return subdivision::GetCornerAt(this->Out,
        this->GetOnPiece(corner, (this->GetNumberOfPieces() - 1) / 2),
        this->GetPoint(this->Refiner.Mesh.Edges[corner], i));
    }
    Id GetCornerInFan(Id corner) const
    {
      return subdivision::GetCornerAt(this->Out, this->Refiner.Children.GetHalfEdgeAt(corner),
        this->Refiner.Mesh.Vertices[corner]);
    }
  };

  void SetFreeEdges(const Pieces& pieces, PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.EdgeCorners.size(),
      [&](vtkIdType e)
      {
        for (int i = 0; i < pieces.GetNumberOfPieces() && this->Mesh.EdgeCorners[e] < 0; ++i)
        {
          out.EdgeCorners[pieces.GetPiece(static_cast<Id>(e), i)] = -1;
        }
      });
  }
  void SetVertexCorners(const Pieces& pieces, PolygonMesh<Id>& out) const
  {
    ForEach(this->Mesh.NumberOfVertices,
      [&](vtkIdType v)
      {
        const Id corner = this->Mesh.VertexCorners[v];
        out.VertexCorners[v] = corner < 0 ? corner : pieces.GetCornerInFan(corner);
      });
    ForEach(this->Mesh.NumberOfFaces,
      [&](vtkIdType f)
      {
        const Id face = static_cast<Id>(f);
        const Id centre = this->Children.GetCentre(face);
        if (centre >= 0)
        {
          out.VertexCorners[centre] = subdivision::GetCornerAt(
            out, this->Children.GetSideAtBegin(this->Mesh.GetFirst(face)), centre);
        }
      });
    const int points = pieces.GetNumberOfPieces() - 1;
    ForEach(points > 0 ? this->Mesh.GetNumberOfEdges() : 0,
      [&](vtkIdType e)
      {
        const Id corner = this->Mesh.EdgeCorners[e];
        for (int i = 0; i < points && this->IsSharp(e); ++i) // -1 for free edges until SplitJoints
        {
          out.VertexCorners[pieces.GetPoint(static_cast<Id>(e), i)] =
            corner < 0 ? -1 : pieces.GetCornerAt(corner, i);
        }
      });
  }
};

/// Base class of the schemes.
template <typename Id, typename Topology>
class CentreScheme : public SurfaceScheme<Id>
{
public:
  bool HalvesEdges() const override { return false; }
  void RestrictTags(SurfaceLevel<Id>& level) const override { FixEdges(level); }
  int GetCarrierPeriod() const override { return 2; }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return Topology(level).GetNumberOfVertices();
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const Topology topology(level);
    const vtkIdType centre = row - mesh.NumberOfVertices;
    if (centre < 0)
    {
      parents.assign({ row });
    }
    else if (row < topology.GetEndOfCentres())
    {
      const Id face = topology.FindFace(static_cast<Id>(centre));
      const Id* first = mesh.Vertices.data() + mesh.GetFirst(face);
      parents.assign(first, first + mesh.GetSize(face));
    }
    else
    {
      const Id edge = topology.FindCutEdge(static_cast<Id>(row));
      parents.assign({ mesh.EdgeVertices[2 * edge], mesh.EdgeVertices[2 * edge + 1] });
    }
  }
  /// Pieces of fixed edges are sharp, and the points that cut them lie on curves. Old vertices keep
  /// their tags, and all else is smooth.
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override
  {
    return MakeTags(level, tags, true);
  }

protected:
  template <typename Refiner>
  static SurfaceLevel<Id> RefineBy(
    const Refiner& refiner, const SurfaceLevel<Id>& level, Depth depth)
  {
    SurfaceLevel<Id> next = refiner.Run(depth);
    if (depth != Depth::ForCounts)
    {
      next.Tags = MakeTags(level, level.Tags, !next.Mesh.EdgeCorners.empty());
    }
    return next;
  }

private:
  /// `ofEdges`: the tags of edges too.
  static SurfaceTags<Id> MakeTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, bool ofEdges)
  {
    const Topology children(level);
    SurfaceTags<Id> out;
    out.Edges = Buffer<EdgeTag>(ofEdges ? children.GetNumberOfEdges() : 0);
    out.Vertices = Buffer<VertexTag>(children.GetNumberOfVertices());
    ForEach(out.Edges.size(), [&](vtkIdType e) { out.Edges[e] = children.GetEdgeTag(e, tags); });
    ForEach(out.Vertices.size(),
      [&](vtkIdType v)
      {
        out.Vertices[v] = v < level.Mesh.NumberOfVertices ? tags.Vertices[v]
          : v < children.GetEndOfCentres()                ? VertexTag::Smooth
                                                          : VertexTag::Curve;
      });
    out.Sectors = tags.Sectors;
    MoveSectors(
      level.Mesh, tags, [&](Id fixed, Id vertex) { return children.GetCornerAtEnd(fixed, vertex); },
      out.Sectors);
    return out;
  }
};

}

#endif
