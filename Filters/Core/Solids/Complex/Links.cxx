// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Complex/Links.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Rows that list, for each of `rows` members, the owners whose `perOwner` members include it.
template <typename Id>
Rows<Id> Invert(const Buffer<Id>& members, int perOwner, vtkIdType rows)
{
  if (members.empty())
  {
    return { Buffer<Id>(rows + 1, Id(0)), Buffer<Id>() };
  }
  return ListByRow<Id>(
    rows, members.size(), [&](vtkIdType i) { return members[i]; },
    [perOwner](vtkIdType i) { return static_cast<Id>(i / perOwner); });
}

}

template <typename Id>
Links<Id>::Links(const SimplicialComplex<Id>& complex)
  : Complex(complex)
  , VertexEdges(Invert(complex.EdgeVertices, 2, complex.NumberOfVertices))
  , EdgeFaces(Invert(complex.FaceEdges, 3, complex.NumberOfEdges))
  , Dimensions(this->FindEdgeDimensions())
{
}

template <typename Id>
Buffer<unsigned char> Links<Id>::FindEdgeDimensions() const
{
  Buffer<unsigned char> dimensions(this->Complex.NumberOfEdges);
  ForEach(this->Complex.NumberOfEdges,
    [&](vtkIdType edge)
    {
      const Row<Id> faces = this->EdgeFaces[edge];
      unsigned char found = faces.size() == 0 ? DimensionBit(1) : 0;
      for (Id face : faces)
      {
        found |= this->FaceDimension(face);
      }
      dimensions[edge] = found;
    });
  return dimensions;
}

template <typename Id>
unsigned char Links<Id>::VertexDimensions(Id vertex) const
{
  unsigned char dimensions = 0;
  for (Id edge : this->VertexEdges[vertex])
  {
    dimensions |= this->EdgeDimensions(edge);
  }
  return dimensions;
}

template <typename Id>
Place Links<Id>::PlaceEdge(Id edge, int k) const
{
  if (!(this->EdgeDimensions(edge) & DimensionBit(k)))
  {
    return Place::Outside;
  }
  if (k == 3)
  {
    return this->PlaceEdgeInSolid(edge);
  }
  if (k == 1)
  {
    return Place::Interior;
  }
  int triangles = 0;
  for (Id face : this->EdgeFaces[edge])
  {
    triangles += this->FaceDimension(face) == DimensionBit(2) ? 1 : 0;
  }
  return triangles == 0 ? Place::Outside
    : triangles == 1    ? Place::Boundary
    : triangles == 2    ? Place::Interior
                        : Place::Type2;
}

/// The link of an edge in C_3 is a graph: a node for each face at the edge, an arc for each
/// tetrahedron; a node's degree is the number of tetrahedra at the face.
template <typename Id>
Place Links<Id>::PlaceEdgeInSolid(Id edge) const
{
  vtkIdType nodes = 0;
  vtkIdType ends = 0;
  for (Id face : this->EdgeFaces[edge])
  {
    const vtkIdType degree = this->Complex.FaceTets[face].size();
    if (degree > 2)
    {
      return Place::Type2;
    }
    nodes += degree > 0 ? 1 : 0;
    ends += degree == 1 ? 1 : 0;
  }
  if (nodes == 0)
  {
    return Place::Outside;
  }
  if (ends > 2 || !this->IsConnectedAround(edge, nodes))
  {
    return Place::Type3;
  }
  return ends == 0 ? Place::Interior : Place::Boundary;
}

/// Whether the link of an edge in C_3 is connected: `faces` nodes, none of which has more than two
/// tetrahedra, and two or none have one. Walks around the edge from one of these two if there are
/// any. What it does not come to are cycles, of three faces at least, so that it may stop before
/// the last two.
template <typename Id>
bool Links<Id>::IsConnectedAround(Id edge, vtkIdType faces) const
{
  Id start = -1;
  for (Id face : this->EdgeFaces[edge])
  {
    const vtkIdType degree = this->Complex.FaceTets[face].size();
    if (degree > 0 && (start < 0 || degree == 1))
    {
      start = face;
    }
  }
  vtkIdType met = 1;
  Id face = start;
  Id tet = -1;
  while (met + 2 < faces)
  {
    const Row<Id> tets = this->Complex.FaceTets[face];
    const Id* next = tets.begin();
    if (*next == tet && ++next == tets.end())
    {
      return false; // the other end
    }
    tet = *next;
    // The other face of this tetrahedron at the edge.
    const Id third = this->Complex.VertexOpposite(face, edge);
    int local = 0;
    for (int i = 0; i < 4; ++i)
    {
      const Id vertex = this->Complex.TetVertices[4 * tet + i];
      local = vertex == third ? i : local;
    }
    face = this->Complex.TetFaces[4 * tet + local];
    if (face == start)
    {
      return false;
    }
    ++met;
  }
  return true;
}

template <typename Id>
Place Links<Id>::PlaceVertex(Id vertex, int k, const Buffer<Place>& edgePlaces) const
{
  if (k == 3)
  {
    return this->PlaceVertexInSolid(vertex, edgePlaces);
  }
  if (k == 2)
  {
    return this->PlaceVertexInSurface(vertex);
  }
  int lines = 0;
  for (Id edge : this->VertexEdges[vertex])
  {
    lines += this->EdgeFaces[edge].size() == 0 ? 1 : 0;
  }
  return lines == 0 ? Place::Outside
    : lines == 1    ? Place::Boundary
    : lines == 2    ? Place::Interior
                    : Place::Type2;
}

/// The link of a vertex in C_2 is a graph: a node for each edge, an arc for each triangle.
template <typename Id>
Place Links<Id>::PlaceVertexInSurface(Id vertex) const
{
  vtkIdType nodes = 0;
  vtkIdType ends = 0;
  Id start = -1; // an end of the link if there is one
  for (Id edge : this->VertexEdges[vertex])
  {
    switch (this->PlaceEdge(edge, 2))
    {
      case Place::Type2:
        return Place::Type2;
      case Place::Boundary:
        ++ends;
        ++nodes;
        start = edge;
        break;
      case Place::Interior:
        ++nodes;
        start = start < 0 ? edge : start;
        break;
      default:
        break;
    }
  }
  if (nodes == 0)
  {
    return Place::Outside;
  }
  if (ends > 2 || !this->IsOneFan(vertex, start, nodes))
  {
    return Place::Type3;
  }
  return ends == 0 ? Place::Interior : Place::Boundary;
}

/// Whether the triangles at a vertex form one fan: `edges` edges lie on them, none of which has
/// more than two, and two or none have one. Walks from `start`, one of these two if there are any.
/// What it does not come to are cycles, of three edges at least, so that it may stop before the
/// last two.
template <typename Id>
bool Links<Id>::IsOneFan(Id vertex, Id start, vtkIdType edges) const
{
  auto isTriangle = [this](Id face) { return this->FaceDimension(face) == DimensionBit(2); };
  vtkIdType met = 1;
  Id edge = start;
  Id face = -1;
  while (met + 2 < edges)
  {
    const Row<Id> faces = this->EdgeFaces[edge];
    const Id* next = std::find_if(
      faces.begin(), faces.end(), [&](Id other) { return other != face && isTriangle(other); });
    if (next == faces.end())
    {
      return false; // the other end
    }
    face = *next;
    edge = this->Complex.OtherEdge(face, edge, vertex);
    if (edge == start)
    {
      return false;
    }
    ++met;
  }
  return true;
}

/// The link of a vertex in C_3 is a surface: a vertex for each edge, an edge for each face, a
/// triangle for each tetrahedron. Connected, with manifold vertices and Euler characteristic 2 it
/// is a sphere; with a boundary and characteristic 1, a disk.
template <typename Id>
Place Links<Id>::PlaceVertexInSolid(Id vertex, const Buffer<Place>& edgePlaces) const
{
  vtkIdType vertices = 0;
  vtkIdType twiceEdges = 0;
  vtkIdType sixTriangles = 0; // six times their number: the loops below meet a tetrahedron at three
                              // edges, and there on two faces
  vtkIdType ends = 0;
  bool severalPieces = false;
  for (Id edge : this->VertexEdges[vertex])
  {
    const Place place = edgePlaces[edge];
    if (place == Place::Outside)
    {
      continue;
    }
    if (place == Place::Type2)
    {
      return Place::Type2;
    }
    severalPieces = severalPieces || place == Place::Type3;
    ++vertices;
    for (Id face : this->EdgeFaces[edge])
    {
      const vtkIdType tets = this->Complex.FaceTets[face].size();
      twiceEdges += tets > 0 ? 1 : 0;
      sixTriangles += tets;
      ends += tets == 1 ? 1 : 0;
    }
  }
  if (vertices == 0)
  {
    return Place::Outside;
  }
  const vtkIdType euler = vertices - twiceEdges / 2 + sixTriangles / 6;
  const bool interior = ends == 0 && euler == 2;
  const bool boundary = ends > 0 && euler == 1;
  if (severalPieces || (!interior && !boundary) ||
    this->CountPieces(
      vertex, [this](Id face) { return this->FaceDimension(face) == DimensionBit(3); }) != 1)
  {
    return Place::Type3;
  }
  return interior ? Place::Interior : Place::Boundary;
}

SUBDIVISION_COMPILE(class Links);

}
