// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceRings.h
 * The surroundings of a vertex of a surface: edges, sharp edges, the sector of a face.
 */
#ifndef SubdivisionObjects_SurfaceRings_h
#define SubdivisionObjects_SurfaceRings_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include "Core/Rules/Pi.h"

#include <algorithm>

namespace subdivision
{

/// Calls visit(corner) for one corner of each fan of a vertex.
template <typename Id, typename Visit>
void VisitFans(const PolygonMesh<Id>& mesh, Id vertex, const Visit& visit)
{
  if (mesh.VertexCorners[vertex] >= 0)
  {
    visit(mesh.VertexCorners[vertex]);
  }
  else if (const auto* joint = mesh.FindJoint(vertex))
  {
    for (Id corner : joint->Fans)
    {
      visit(corner);
    }
  }
}

/// Calls visit(face) for each face at a vertex.
template <typename Id, typename Visit>
void VisitFaces(const PolygonMesh<Id>& mesh, Id vertex, const Visit& visit)
{
  VisitFans(mesh, vertex,
    [&](Id corner)
    {
      VisitFan(mesh, corner, [&](const FanStep<Id>& step) { visit(mesh.GetFace(step.Corner)); });
    });
}

/// Appends the ids stored for each corner of a face: its vertices or its edges.
template <typename Id>
void AppendOfFace(
  const PolygonMesh<Id>& mesh, const Buffer<Id>& ofCorners, Id face, std::vector<Id>& ids)
{
  const Id* first = ofCorners.data() + mesh.GetFirst(face);
  ids.insert(ids.end(), first, first + mesh.GetSize(face));
}

/// Sorts a few ids, and keeps one of several equal ones.
template <typename Id>
void SortUnique(std::vector<Id>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// The corner that VisitFans visits first; -1: the vertex has no faces.
template <typename Id>
Id GetFirstFan(const PolygonMesh<Id>& mesh, Id vertex)
{
  const auto* joint = mesh.FindJoint(vertex);
  return !joint ? mesh.VertexCorners[vertex] : joint->Fans.empty() ? Id(-1) : joint->Fans.front();
}

/// All edges of a vertex that `accept` takes, each once.
template <typename Id, typename Accept>
void CollectEdges(
  const PolygonMesh<Id>& mesh, Id vertex, const Accept& accept, std::vector<Id>& edges)
{
  edges.clear();
  auto add = [&](Id edge)
  {
    if (accept(edge))
    {
      edges.push_back(edge);
    }
  };
  const auto* joint = mesh.FindJoint(vertex);
  VisitFans(mesh, vertex,
    [&](Id corner)
    {
      FanStep<Id> last{ corner, true };
      const bool isCycle = VisitFan(mesh, corner,
        [&](const FanStep<Id>& step)
        {
          add(mesh.Edges[step.GetHalfEdgeIn(mesh)]);
          last = step;
        });
      if (!isCycle)
      {
        add(mesh.Edges[last.GetHalfEdgeOut(mesh)]);
      }
    });
  if (joint)
  {
    for (Id edge : joint->FreeEdges)
    {
      add(edge);
    }
    // Edges of three and more faces end several fans.
    SortUnique(edges);
  }
}

template <typename Id>
void CollectSharpEdges(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex, std::vector<Id>& edges)
{
  CollectEdges(mesh, vertex, [&tags](Id e) { return IsSharp(tags.Edges[e]); }, edges);
}

/// Collects the two edges along which a curve goes through a vertex: its two creases or, if it has
/// not exactly two, its two EdgeTag::Joint edges, or else its sharp edges (Mathematics 4, 6). If
/// the result has not two edges, there is no curve.
template <typename Id>
void CollectCurveEdges(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex, std::vector<Id>& edges)
{
  CollectSharpEdges(mesh, tags, vertex, edges);
  for (const EdgeTag kind : { EdgeTag::Crease, EdgeTag::Joint })
  {
    auto isOther = [&tags, kind](Id edge) { return tags.Edges[edge] != kind; };
    if (std::count_if(edges.begin(), edges.end(), isOther) + 2 ==
      static_cast<std::ptrdiff_t>(edges.size()))
    {
      edges.erase(std::remove_if(edges.begin(), edges.end(), isOther), edges.end());
    }
  }
}

/// The ends of a sector: of the faces around a vertex from one edge that is not smooth to the next.
template <typename Id>
struct SectorEnds
{
  FanStep<Id> First{ 0, true }; ///< the first face, entered by the edge that begins the sector
  FanStep<Id> Last{ 0, true };
  int Size = 0; ///< number of faces; 0: no edge ends the sector, or the same edge on both sides
};

/// Finds the sector of the face of a corner. It begins at the edge that a walk forward from the
/// corner reaches.
template <typename Id>
SectorEnds<Id> FindSectorEnds(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id corner)
{
  SectorEnds<Id> ends;
  FanStep<Id> step{ corner, true };
  auto isAtEnd = [&]
  { return tags.Edges[mesh.Edges[step.GetHalfEdgeOut(mesh)]] != EdgeTag::Smooth; };
  while (!isAtEnd())
  {
    if (!step.Advance(mesh) || step.Corner == corner)
    {
      return ends;
    }
  }
  ends.First = step.Turn();
  const Id begin = step.GetHalfEdgeOut(mesh);
  step = ends.First;
  ends.Size = 1;
  while (!isAtEnd())
  {
    step.Advance(mesh);
    ++ends.Size;
  }
  ends.Last = step;
  if (mesh.Twins[begin] >= 0 && mesh.Edges[begin] == mesh.Edges[step.GetHalfEdgeOut(mesh)])
  {
    ends.Size = 0; // all around the end of a crease
  }
  return ends;
}

/// Whether a curve goes through a vertex; at joints not every vertex with that tag moves along one.
template <typename Id>
bool IsOnCurve(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex)
{
  if (tags.Vertices[vertex] != VertexTag::Curve || !mesh.FindJoint(vertex))
  {
    return tags.Vertices[vertex] == VertexTag::Curve;
  }
  std::vector<Id> edges;
  CollectCurveEdges(mesh, tags, vertex, edges);
  return edges.size() == 2;
}

/// A corner in the sector whose tangents a vertex has: the first fan's or, where a curve goes
/// through a joint, the first one between the two edges of the curve. -1: there is none.
template <typename Id>
Id FindTangentCorner(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex)
{
  std::vector<Id> curve;
  const bool isAtJoint = mesh.FindJoint(vertex) && IsOnCurve(mesh, tags, vertex);
  if (isAtJoint)
  {
    CollectCurveEdges(mesh, tags, vertex, curve);
  }
  auto isOnCurve = [&](Id halfEdge)
  { return std::find(curve.begin(), curve.end(), mesh.Edges[halfEdge]) != curve.end(); };
  Id found = -1;
  VisitFans(mesh, vertex,
    [&](Id corner)
    {
      const SectorEnds<Id> ends = isAtJoint ? FindSectorEnds(mesh, tags, corner) : SectorEnds<Id>();
      const bool isBetween = !isAtJoint ||
        (ends.Size > 0 && isOnCurve(ends.First.GetHalfEdgeIn(mesh)) &&
          isOnCurve(ends.Last.GetHalfEdgeOut(mesh)));
      found = found < 0 && isBetween ? corner : found;
    });
  return found;
}

/// An iterator to the first sector of a vertex or, if it has none, of a later vertex.
template <typename Id>
auto FindSectors(const SurfaceTags<Id>& tags, Id vertex)
{
  return std::lower_bound(tags.Sectors.begin(), tags.Sectors.end(), vertex,
    [](const Sector<Id>& sector, Id v) { return sector.Vertex < v; });
}

/// The sector of that corner which VisitFans visits first; null if there is none. This works on all
/// levels, also in schemes whose sectors keep the corners of the control level.
template <typename Id>
const Sector<Id>* FindFirstSector(const SurfaceTags<Id>& tags, Id vertex)
{
  const auto at = FindSectors(tags, vertex);
  return at != tags.Sectors.end() && at->Vertex == vertex ? &*at : nullptr;
}

/// The record of the sector with these ends, in either order; null if there is none.
template <typename Id>
const Sector<Id>* FindSector(const SurfaceTags<Id>& tags, Id vertex, const SectorEnds<Id>& ends)
{
  auto at = FindSectors(tags, vertex);
  for (; at != tags.Sectors.end() && at->Vertex == vertex; ++at)
  {
    if (at->First == ends.First.Corner || at->First == ends.Last.Corner)
    {
      return &*at;
    }
  }
  return nullptr;
}

/// The sector of the same faces in other tags of the same level; null if there is none.
template <typename Id>
const Sector<Id>* FindEqualSector(const SurfaceTags<Id>& tags, const Sector<Id>& sector)
{
  for (auto at = FindSectors(tags, sector.Vertex);
    at != tags.Sectors.end() && at->Vertex == sector.Vertex; ++at)
  {
    if (at->First == sector.First && at->Size == sector.Size)
    {
      return &*at;
    }
  }
  return nullptr;
}

/// The angle t of one face of a sector (Mathematics 12) at `vertex`, one end of a smooth edge; 0 if
/// the plain rule applies there.
template <typename Id>
double FindAngleOfFace(
  const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex, Id corner)
{
  const VertexTag tag = tags.Vertices[vertex];
  if (tag != VertexTag::Curve && tag != VertexTag::Corner)
  {
    return 0.;
  }
  const SectorEnds<Id> ends = FindSectorEnds(mesh, tags, corner);
  if (ends.Size == 0)
  {
    return 0.;
  }
  if (tag == VertexTag::Curve)
  {
    return Pi / ends.Size;
  }
  const Sector<Id>* sector = FindSector(tags, vertex, ends);
  return sector ? sector->Angle / ends.Size : 0.;
}

/// The corner of a vertex in the face of a half-edge that begins or ends there.
template <typename Id>
Id GetCornerAt(const PolygonMesh<Id>& mesh, Id halfEdge, Id vertex)
{
  return mesh.Vertices[halfEdge] == vertex ? halfEdge : mesh.Next(halfEdge);
}

}

#endif
