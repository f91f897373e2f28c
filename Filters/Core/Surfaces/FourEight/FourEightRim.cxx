// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightRim.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

namespace subdivision
{
namespace
{

template <typename T>
void Extend(Buffer<T>& buffer, vtkIdType by)
{
  Buffer<T> longer(buffer.size() + by);
  std::copy(buffer.begin(), buffer.end(), longer.begin());
  buffer = std::move(longer);
}

/// The corners at whose edges the patch ends and the level goes on.
template <typename Id>
std::vector<Id> FindRim(const PolygonMesh<Id>& whole, const SurfacePatch<Id>& patch)
{
  const PolygonMesh<Id>& mesh = patch.Level.Mesh;
  std::vector<Id> rim;
  for (const Id corner : InTurn(static_cast<Id>(mesh.GetNumberOfCorners())))
  {
    const Id face = mesh.GetFace(corner);
    const Id same = whole.GetFirst(patch.Faces[face]) + corner - mesh.GetFirst(face);
    if (mesh.Twins[corner] < 0 && whole.Twins[same] >= 0)
    {
      rim.push_back(corner);
    }
  }
  return rim;
}

template <typename Id>
class RimMaker
{
public:
  RimMaker(PolygonMesh<Id>& mesh, SurfaceTags<Id>& tags)
    : Mesh(mesh)
    , Tags(tags)
  {
  }

  void Run(const std::vector<Id>& rim)
  {
    PolygonMesh<Id>& mesh = this->Mesh;
    const auto size = static_cast<vtkIdType>(rim.size());
    this->Vertex = static_cast<Id>(mesh.NumberOfVertices);
    this->Edge = static_cast<Id>(mesh.GetNumberOfEdges());
    this->Corner = static_cast<Id>(mesh.GetNumberOfCorners());
    this->StoreOffsets(3 * size);
    for (Buffer<Id>* of : { &mesh.Vertices, &mesh.Edges, &mesh.Twins })
    {
      Extend(*of, 9 * size);
    }
    Extend(mesh.EdgeVertices, 10 * size);
    Extend(mesh.EdgeCorners, 5 * size);
    Extend(mesh.VertexCorners, 2 * size);
    Extend(this->Tags.Edges, 5 * size);
    Extend(this->Tags.Vertices, 2 * size);
    mesh.NumberOfVertices += 2 * size;
    for (const Id corner : rim)
    {
      this->Add(corner);
      this->Vertex += 2;
      this->Edge += 5;
      this->Corner += 9;
    }
  }

private:
  /// The new faces are triangles, whatever the others are.
  void StoreOffsets(vtkIdType faces)
  {
    PolygonMesh<Id>& mesh = this->Mesh;
    const vtkIdType old = mesh.NumberOfFaces;
    Buffer<Id> offsets(old + faces + 1);
    Buffer<Id> cornerFaces(this->Corner + 3 * faces);
    for (vtkIdType f = 0; f <= old + faces; ++f)
    {
      offsets[f] =
        f < old ? mesh.GetFirst(static_cast<Id>(f)) : this->Corner + static_cast<Id>(3 * (f - old));
    }
    for (vtkIdType f = 0; f < old + faces; ++f)
    {
      std::fill(
        cornerFaces.begin() + offsets[f], cornerFaces.begin() + offsets[f + 1], static_cast<Id>(f));
    }
    mesh.FaceOffsets = std::move(offsets);
    mesh.CornerFaces = std::move(cornerFaces);
    mesh.NumberOfFaces += faces;
    mesh.Arity = 0;
  }

  /// The triangles bam, adm and dbm over the edge ab of a corner.
  void Add(Id corner)
  {
    PolygonMesh<Id>& mesh = this->Mesh;
    const Id a = mesh.Vertices[corner];
    const Id b = mesh.Vertices[mesh.Next(corner)];
    const Id m = this->Vertex;
    const Id d = this->Vertex + 1;
    const Id edge = this->Edge;
    const Id first = this->Corner;
    const Id vertices[9] = { b, a, m, a, d, m, d, b, m };
    const Id edges[9] = { mesh.Edges[corner], edge, static_cast<Id>(edge + 1),
      static_cast<Id>(edge + 2), static_cast<Id>(edge + 3), edge, static_cast<Id>(edge + 4),
      static_cast<Id>(edge + 1), static_cast<Id>(edge + 3) };
    const Id ends[10] = { a, m, m, b, a, d, d, m, d, b };
    constexpr int twins[9] = { 0, 5, 7, -1, 8, 1, -1, 2, 4 };
    constexpr int firstCorners[5] = { 1, 2, 3, 4, 6 };
    for (int i = 0; i < 9; ++i)
    {
      mesh.Vertices[first + i] = vertices[i];
      mesh.Edges[first + i] = edges[i];
      mesh.Twins[first + i] = twins[i] < 0 ? -1 : first + twins[i];
    }
    mesh.Twins[first] = corner;
    mesh.Twins[corner] = first;
    std::copy(ends, ends + 10, mesh.EdgeVertices.begin() + 2 * edge);
    for (int i = 0; i < 5; ++i)
    {
      mesh.EdgeCorners[edge + i] = first + firstCorners[i];
      this->Tags.Edges[edge + i] = i == 2 || i == 4 ? EdgeTag::Sharp : EdgeTag::Smooth;
    }
    mesh.VertexCorners[m] = first + 2;
    mesh.VertexCorners[d] = first + 4;
    this->Tags.Vertices[m] = VertexTag::Corner;
    this->Tags.Vertices[d] = VertexTag::Corner;
  }

  PolygonMesh<Id>& Mesh;
  SurfaceTags<Id>& Tags;
  Id Vertex = 0; ///< the next one that is new
  Id Edge = 0;
  Id Corner = 0;
};

}

template <typename Id>
void CloseRim(const SurfaceLevel<Id>& whole, SurfacePatch<Id>& patch)
{
  for (std::size_t e = 0; e < patch.Edges.size(); ++e)
  {
    patch.Level.Tags.Edges[static_cast<vtkIdType>(e)] = whole.Tags.Edges[patch.Edges[e]];
  }
  const std::vector<Id> rim = FindRim(whole.Mesh, patch);
  if (!rim.empty())
  {
    RimMaker<Id>(patch.Level.Mesh, patch.Level.Tags).Run(rim);
  }
}

SUBDIVISION_COMPILE_FUNCTION(CloseRim);

}
