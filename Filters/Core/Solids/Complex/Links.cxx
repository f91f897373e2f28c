// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Complex/Links.h"

#include "Core/Cells/CellComplex.h"
#include "Core/Memory/Ids.h"
#include "Core/Solids/Complex/Simplices.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Of an edge of so many triangles that lie in no solid, and of no solid: the link in C_2 is a
/// point for each.
EdgeFacts FactsInSurface(vtkIdType triangles)
{
  EdgeFacts facts;
  facts.Dimensions = DimensionBit(triangles == 0 ? 1 : 2);
  facts.InSurface = triangles == 0 ? Place::Outside
    : triangles == 1               ? Place::Boundary
    : triangles == 2               ? Place::Interior
                                   : Place::Type2;
  return facts;
}

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

template <typename Id, typename AnyComplex>
Links<Id, AnyComplex>::Links(const AnyComplex& complex)
  : Complex(complex)
  , VertexEdges(Invert(complex.EdgeVertices, 2, complex.NumberOfVertices))
  , OwnFaces(complex.EdgeFaces.Offsets.empty() ? Invert(complex.FaceEdges, 3, complex.NumberOfEdges)
                                               : Rows<Id>())
  , EdgeFaces(complex.EdgeFaces.Offsets.empty() ? this->OwnFaces : complex.EdgeFaces)
  , OnlyDimension(this->FindOnlyDimension())
  , Facts(this->FindFacts())
{
}

template <typename Id, typename AnyComplex>
Buffer<EdgeFacts> Links<Id, AnyComplex>::FindFacts() const
{
  const vtkIdType edges = this->Complex.NumberOfEdges;
  Buffer<EdgeFacts> facts(edges);
  if (this->Complex.NumberOfTets == 0)
  {
    EdgeFacts ofSizes[4];
    for (int triangles = 0; triangles < 4; ++triangles)
    {
      ofSizes[triangles] = FactsInSurface(triangles);
    }
    ForEach(edges, [&](vtkIdType edge)
      { facts[edge] = ofSizes[std::min<vtkIdType>(this->EdgeFaces[edge].size(), 3)]; });
    return facts;
  }
  ForEach(edges, [&](vtkIdType edge) { facts[edge] = this->FindFacts(static_cast<Id>(edge)); });
  return facts;
}

/// The link of an edge in C_3 is a graph: a node for each face at the edge, an arc for each
/// tetrahedron; a node's degree is the number of tetrahedra at the face.
template <typename Id, typename AnyComplex>
EdgeFacts Links<Id, AnyComplex>::FindFacts(Id edge) const
{
  const Row<Id> faces = this->EdgeFaces[edge];
  vtkIdType nodes = 0;
  vtkIdType ends = 0;
  vtkIdType most = 0;
  for (const Id face : faces)
  {
    const vtkIdType degree = GetSolidsAt(this->Complex, face).size();
    nodes += degree > 0 ? 1 : 0;
    ends += degree == 1 ? 1 : 0;
    most = std::max(most, degree);
  }
  EdgeFacts facts = FactsInSurface(faces.size() - nodes);
  if (nodes > 0)
  {
    // Lines have no faces.
    facts.Dimensions = static_cast<unsigned char>(
      DimensionBit(3) | (facts.InSurface == Place::Outside ? 0 : DimensionBit(2)));
    facts.InSolid = most > 2                                         ? Place::Type2
      : ends > 2 || !this->IsConnectedAround(edge, nodes, ends == 0) ? Place::Type3
      : ends == 0                                                    ? Place::Interior
                                                                     : Place::Boundary;
  }
  return facts;
}

template <typename Id, typename AnyComplex>
unsigned char Links<Id, AnyComplex>::FindOnlyDimension() const
{
  const AnyComplex& complex = this->Complex;
  return complex.HasEdgesAlone()         ? DimensionBit(1)
    : complex.NumberOfLineCells > 0      ? 0
    : complex.NumberOfTets == 0          ? DimensionBit(2)
    : complex.NumberOfTriangleCells == 0 ? DimensionBit(3)
                                         : 0;
}

template <typename Id, typename AnyComplex>
unsigned char Links<Id, AnyComplex>::VertexDimensions(Id vertex) const
{
  unsigned char dimensions = 0;
  if (this->OnlyDimension)
  {
    return this->VertexEdges[vertex].size() > 0 ? this->OnlyDimension : dimensions;
  }
  for (Id edge : this->VertexEdges[vertex])
  {
    dimensions |= this->EdgeDimensions(edge);
  }
  return dimensions;
}

/// Whether the link of an edge in C_3 is connected: `faces` nodes, none of which has more than two
/// solids, and two or none have one. Walks around the edge from one of these two if there are any.
/// Faces that the walk does not reach are in cycles of three at least (of two where cells are no
/// simplices), so that it may stop before the last ones.
template <typename Id, typename AnyComplex>
bool Links<Id, AnyComplex>::IsConnectedAround(Id edge, vtkIdType faces, bool isClosed) const
{
  const vtkIdType least = GetLeastCycle(this->Complex);
  if (faces < (isClosed ? 2 * least : 2 + least))
  {
    return true;
  }
  Id start = -1;
  for (Id face : this->EdgeFaces[edge])
  {
    const vtkIdType degree = GetSolidsAt(this->Complex, face).size();
    if (degree > 0 && (start < 0 || degree == 1))
    {
      start = face;
    }
  }
  vtkIdType met = 1;
  Id face = start;
  Id tet = -1;
  while (met + least <= faces)
  {
    const Row<Id> tets = GetSolidsAt(this->Complex, face);
    const Id* next = tets.begin();
    if (*next == tet && ++next == tets.end())
    {
      return false; // the other end
    }
    tet = *next;
    face = GetOtherFace(this->Complex, tet, face, edge);
    if (face == start || face < 0)
    {
      return false;
    }
    ++met;
  }
  return true;
}

template <typename Id, typename AnyComplex>
Place Links<Id, AnyComplex>::PlaceVertex(Id vertex, int k) const
{
  if (k == 3)
  {
    return this->PlaceVertexInSolid(vertex);
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
template <typename Id, typename AnyComplex>
Place Links<Id, AnyComplex>::PlaceVertexInSurface(Id vertex) const
{
  vtkIdType nodes = 0;
  vtkIdType ends = 0;
  Id start = -1; // an end of the link if there is one
  for (Id edge : this->VertexEdges[vertex])
  {
    switch (this->Facts[edge].InSurface)
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
  if (ends > 2 || !this->IsOneFan(vertex, start, nodes, ends == 0))
  {
    return Place::Type3;
  }
  return ends == 0 ? Place::Interior : Place::Boundary;
}

/// Whether the triangles at a vertex form one fan: `edges` edges lie on them, none of which has
/// more than two, and two or none have one. Walks from `start`, one of these two if there are any.
/// Edges that the walk does not reach are in cycles of three at least, so that it may stop before
/// the last ones.
template <typename Id, typename AnyComplex>
bool Links<Id, AnyComplex>::IsOneFan(Id vertex, Id start, vtkIdType edges, bool isClosed) const
{
  const vtkIdType least = GetLeastCycle(this->Complex);
  if (edges < (isClosed ? 2 * least : 2 + least))
  {
    return true;
  }
  const bool areAll = this->Complex.NumberOfTets == 0;
  auto isTriangle = [=](Id face) { return areAll || this->FaceDimension(face) == DimensionBit(2); };
  vtkIdType met = 1;
  Id edge = start;
  Id face = -1;
  while (met + least <= edges)
  {
    const Row<Id> faces = this->EdgeFaces[edge];
    const Id* next = faces.begin();
    while (next != faces.end() && (*next == face || !isTriangle(*next)))
    {
      ++next;
    }
    if (next == faces.end())
    {
      return false; // the other end
    }
    face = *next;
    edge = GetOtherEdge(this->Complex, face, edge, vertex, this->Complex.GetOtherEnd(edge, vertex));
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
template <typename Id, typename AnyComplex>
Place Links<Id, AnyComplex>::PlaceVertexInSolid(Id vertex) const
{
  const bool areAll = this->Complex.NumberOfTriangleCells == 0;
  const auto isOfSolid = [=](Id face)
  { return areAll || this->FaceDimension(face) == DimensionBit(3); };
  vtkIdType vertices = 0;
  vtkIdType twiceEdges = 0;
  vtkIdType ends = 0; // twice the edges of the boundary: both its ends meet it
  bool severalPieces = false;
  Id start = -1;
  for (Id edge : this->VertexEdges[vertex])
  {
    const Place place = this->Facts[edge].InSolid;
    if (place == Place::Outside)
    {
      continue;
    }
    if (place == Place::Type2)
    {
      return Place::Type2;
    }
    severalPieces = severalPieces || place == Place::Type3;
    const Row<Id> faces = this->EdgeFaces[edge];
    ++vertices;
    start = edge;
    twiceEdges += areAll ? faces.size() : std::count_if(faces.begin(), faces.end(), isOfSolid);
    ends += place == Place::Boundary ? 2 : 0;
  }
  if (vertices == 0)
  {
    return Place::Outside;
  }
  const vtkIdType euler =
    vertices - twiceEdges / 2 + CountSolidsAt(this->Complex, vertex, twiceEdges, ends);
  const bool interior = ends == 0 && euler == 2;
  const bool boundary = ends > 0 && euler == 1;
  if (severalPieces || (!interior && !boundary) ||
    !this->IsOnePiece(vertex, start, vertices, isOfSolid))
  {
    return Place::Type3;
  }
  return interior ? Place::Interior : Place::Boundary;
}

SUBDIVISION_COMPILE(class Links);
template class Links<int, CellComplex<int>>;
template class Links<long long, CellComplex<long long>>;

}
