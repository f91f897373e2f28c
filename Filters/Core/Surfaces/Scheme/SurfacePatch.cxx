// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SurfacePatch.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
SurfacePatch<Id>::SurfacePatch(const SurfaceLevel<Id>& whole, const std::vector<Id>& vertices)
{
  this->Level.Step = whole.Step;
  this->Level.Lines = Buffer<Id>(0);
  this->Collect(whole.Mesh, vertices);
  this->CropFaces(whole.Mesh);
  this->CropEdges(whole.Mesh);
  this->CropVertices(whole.Mesh);
  this->Level.Tags = this->CropTags(whole, whole.Tags);
}

template <typename Id>
Id SurfacePatch<Id>::Find(const std::vector<Id>& ids, Id id)
{
  const auto at = std::lower_bound(ids.begin(), ids.end(), id);
  return at != ids.end() && *at == id ? static_cast<Id>(at - ids.begin()) : Id(-1);
}

template <typename Id>
Id SurfacePatch<Id>::FindCorner(const PolygonMesh<Id>& whole, Id corner) const
{
  const Id face = whole.GetFace(corner);
  const Id own = Find(this->Faces, face);
  return own < 0 ? own : this->Level.Mesh.GetFirst(own) + corner - whole.GetFirst(face);
}

/// Collects first the inside vertices, whose rules the rows of edges and faces at `vertices` read,
/// and then everything at them.
template <typename Id>
void SurfacePatch<Id>::Collect(const PolygonMesh<Id>& whole, const std::vector<Id>& vertices)
{
  std::vector<Id> inside = vertices;
  std::vector<Id> around;
  auto collectEdges = [&](Id vertex)
  { CollectEdges(whole, vertex, [](Id) { return true; }, around); };
  for (Id vertex : vertices)
  {
    collectEdges(vertex);
    for (Id edge : around)
    {
      inside.push_back(whole.GetOtherEnd(edge, vertex));
    }
    // The flatness of a corner moves the points of its faces, also of faces in which it is no
    // neighbour of the vertex.
    VisitFaces(whole, vertex, [&](Id face) { AppendOfFace(whole, whole.Vertices, face, inside); });
  }
  SortUnique(inside);
  for (Id vertex : inside)
  {
    collectEdges(vertex); // free edges too
    this->Edges.insert(this->Edges.end(), around.begin(), around.end());
    VisitFaces(whole, vertex, [&](Id face) { this->Faces.push_back(face); });
  }
  SortUnique(this->Faces);
  for (Id face : this->Faces)
  {
    AppendOfFace(whole, whole.Edges, face, this->Edges);
  }
  SortUnique(this->Edges);
  this->Vertices = inside;
  for (Id edge : this->Edges)
  {
    const Id* ends = whole.EdgeVertices.data() + 2 * static_cast<vtkIdType>(edge);
    this->Vertices.insert(this->Vertices.end(), ends, ends + 2);
  }
  SortUnique(this->Vertices);
  this->IsInside.resize(this->Vertices.size());
  for (std::size_t v = 0; v < this->Vertices.size(); ++v)
  {
    this->IsInside[v] = Find(inside, this->Vertices[v]) >= 0;
  }
}

template <typename Id>
void SurfacePatch<Id>::CropFaces(const PolygonMesh<Id>& whole)
{
  PolygonMesh<Id>& mesh = this->Level.Mesh;
  mesh.Arity = whole.Arity;
  mesh.NumberOfFaces = static_cast<vtkIdType>(this->Faces.size());
  vtkIdType corners = 0;
  mesh.FaceOffsets = Buffer<Id>(mesh.Arity ? 0 : mesh.NumberOfFaces + 1);
  for (const vtkIdType f : InTurn(mesh.NumberOfFaces))
  {
    if (!mesh.Arity)
    {
      mesh.FaceOffsets[f] = static_cast<Id>(corners);
      mesh.FaceOffsets[f + 1] = static_cast<Id>(corners) + whole.GetSize(this->Faces[f]);
    }
    corners += whole.GetSize(this->Faces[f]);
  }
  mesh.CornerFaces = Buffer<Id>(mesh.Arity ? 0 : corners);
  mesh.Vertices = Buffer<Id>(corners);
  mesh.Edges = Buffer<Id>(corners);
  mesh.Twins = Buffer<Id>(corners);
  for (const vtkIdType f : InTurn(mesh.NumberOfFaces))
  {
    const Id from = whole.GetFirst(this->Faces[f]);
    const Id to = mesh.GetFirst(static_cast<Id>(f));
    for (Id i = 0; i < whole.GetSize(this->Faces[f]); ++i)
    {
      if (!mesh.Arity)
      {
        mesh.CornerFaces[to + i] = static_cast<Id>(f);
      }
      mesh.Vertices[to + i] = Find(this->Vertices, whole.Vertices[from + i]);
      mesh.Edges[to + i] = Find(this->Edges, whole.Edges[from + i]);
      const Id twin = whole.Twins[from + i];
      mesh.Twins[to + i] = twin < 0 ? twin : this->FindCorner(whole, twin);
    }
  }
}

template <typename Id>
void SurfacePatch<Id>::CropEdges(const PolygonMesh<Id>& whole)
{
  PolygonMesh<Id>& mesh = this->Level.Mesh;
  const vtkIdType edges = static_cast<vtkIdType>(this->Edges.size());
  mesh.EdgeVertices = Buffer<Id>(2 * edges);
  mesh.EdgeCorners = Buffer<Id>(edges);
  for (vtkIdType e = 0; e < edges; ++e)
  {
    const Id edge = this->Edges[e];
    mesh.EdgeVertices[2 * e] = Find(this->Vertices, whole.EdgeVertices[2 * edge]);
    mesh.EdgeVertices[2 * e + 1] = Find(this->Vertices, whole.EdgeVertices[2 * edge + 1]);
    mesh.EdgeCorners[e] = -1;
  }
  for (vtkIdType c = mesh.GetNumberOfCorners(); c-- > 0;)
  {
    mesh.EdgeCorners[mesh.Edges[c]] = static_cast<Id>(c); // the first one remains
  }
  for (vtkIdType e = 0; e < edges && !whole.Sheaves.empty(); ++e)
  {
    const auto* sheaf = whole.FindSheaf(this->Edges[e]);
    typename PolygonMesh<Id>::Sheaf own{ static_cast<Id>(e), {} };
    for (std::size_t i = 0; sheaf && i < sheaf->Corners.size(); ++i)
    {
      own.Corners.push_back(this->FindCorner(whole, sheaf->Corners[i]));
    }
    if (sheaf && *std::min_element(own.Corners.begin(), own.Corners.end()) >= 0)
    {
      mesh.Sheaves.push_back(std::move(own));
    }
  }
}

template <typename Id>
void SurfacePatch<Id>::CropVertices(const PolygonMesh<Id>& whole)
{
  PolygonMesh<Id>& mesh = this->Level.Mesh;
  mesh.NumberOfVertices = static_cast<vtkIdType>(this->Vertices.size());
  mesh.VertexCorners = Buffer<Id>(mesh.NumberOfVertices);
  std::fill(mesh.VertexCorners.begin(), mesh.VertexCorners.end(), Id(-1));
  for (vtkIdType c = mesh.GetNumberOfCorners(); c-- > 0;)
  {
    mesh.VertexCorners[mesh.Vertices[c]] = static_cast<Id>(c);
  }
  for (const vtkIdType v : InTurn(mesh.NumberOfVertices))
  {
    if (!this->IsInside[v])
    {
      continue;
    }
    const Id corner = whole.VertexCorners[this->Vertices[v]];
    mesh.VertexCorners[v] = corner < 0 ? corner : this->FindCorner(whole, corner);
    if (const auto* joint = whole.FindJoint(this->Vertices[v]))
    {
      typename PolygonMesh<Id>::Joint own{ static_cast<Id>(v), {}, {} };
      for (Id fan : joint->Fans)
      {
        own.Fans.push_back(this->FindCorner(whole, fan));
      }
      for (Id edge : joint->FreeEdges)
      {
        own.FreeEdges.push_back(Find(this->Edges, edge));
      }
      mesh.VertexCorners[v] = static_cast<Id>(-2 - static_cast<vtkIdType>(mesh.Joints.size()));
      mesh.Joints.push_back(std::move(own));
    }
  }
}

template <typename Id>
SurfaceTags<Id> SurfacePatch<Id>::CropTags(
  const SurfaceLevel<Id>& whole, const SurfaceTags<Id>& tags) const
{
  const PolygonMesh<Id>& mesh = this->Level.Mesh;
  SurfaceTags<Id> own;
  own.Edges = Buffer<EdgeTag>(mesh.GetNumberOfEdges());
  for (const vtkIdType e : InTurn(mesh.GetNumberOfEdges()))
  {
    const bool isInside =
      this->IsInside[mesh.EdgeVertices[2 * e]] || this->IsInside[mesh.EdgeVertices[2 * e + 1]];
    own.Edges[e] = isInside ? tags.Edges[this->Edges[e]] : EdgeTag::Sharp;
  }
  own.Vertices = Buffer<VertexTag>(mesh.NumberOfVertices);
  for (const vtkIdType v : InTurn(mesh.NumberOfVertices))
  {
    own.Vertices[v] = this->IsInside[v] ? tags.Vertices[this->Vertices[v]] : VertexTag::Corner;
  }
  for (vtkIdType v = 0; v < mesh.NumberOfVertices && !tags.Sectors.empty(); ++v)
  {
    const Id vertex = this->Vertices[v];
    for (auto at = FindSectors(tags, vertex);
      this->IsInside[v] && at != tags.Sectors.end() && at->Vertex == vertex; ++at)
    {
      // After a step of some schemes sectors keep the corners of the control level.
      const auto findCorner = [&](Id corner)
      {
        const bool isHere = corner >= 0 && corner < whole.Mesh.GetNumberOfCorners() &&
          whole.Mesh.Vertices[corner] == vertex;
        return isHere ? this->FindCorner(whole.Mesh, corner) : Id(-1);
      };
      own.Sectors.push_back(*at);
      own.Sectors.back().Vertex = static_cast<Id>(v);
      own.Sectors.back().First = findCorner(at->First);
      own.Sectors.back().Last = findCorner(at->Last);
    }
  }
  return own;
}

SUBDIVISION_COMPILE(class SurfacePatch);

}
