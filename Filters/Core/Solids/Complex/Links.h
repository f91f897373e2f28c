// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Links.h
 * The links of vertices and edges inside one C_k. A link tells whether the vertex or edge is
 * interior, on the boundary, or non-manifold (the table of Mathematics 3).
 */
#ifndef SubdivisionObjects_Links_h
#define SubdivisionObjects_Links_h

#include "Core/Solids/Complex/SimplicialComplex.h"

#include <vector>

namespace subdivision
{

/// How a simplex lies in C_k.
enum class Place : unsigned char
{
  Outside,
  Interior,
  Boundary,
  Type2,
  Type3
};

/// Bit of C_k in a set of dimensions 1..3.
constexpr unsigned char DimensionBit(int k)
{
  return static_cast<unsigned char>(1 << (k - 1));
}
constexpr unsigned char AllDimensions = 7;

template <typename Id>
class Links
{
public:
  explicit Links(const SimplicialComplex<Id>& complex);

  const SimplicialComplex<Id>& Complex;
  Rows<Id> VertexEdges; ///< all edges at a vertex, in order
  Rows<Id> EdgeFaces;   ///< all faces at an edge, in order

  /// The set of dimensions k for which a simplex lies in C_k, as DimensionBit.
  unsigned char FaceDimension(Id face) const
  {
    return DimensionBit(this->Complex.FaceTets[face].size() > 0 ? 3 : 2);
  }
  unsigned char EdgeDimensions(Id edge) const { return this->Dimensions[edge]; }
  unsigned char VertexDimensions(Id vertex) const;

  /// How an edge lies in C_k.
  Place PlaceEdge(Id edge, int k) const;

  /// How a vertex lies in C_k. `edgePlaces` has PlaceEdge(e, 3) for each edge e.
  Place PlaceVertex(Id vertex, int k, const Buffer<Place>& edgePlaces) const;

  /// Whether the faces at a vertex that `accept` takes form one closed fan around it.
  template <typename Accept>
  bool IsClosedFan(Id vertex, const Accept& accept) const;

  /// Number of pieces of the graph whose nodes are the edges at a vertex that lie on accepted faces
  /// and whose arcs are those faces.
  template <typename Accept>
  int CountPieces(Id vertex, const Accept& accept) const;

private:
  Buffer<unsigned char> FindEdgeDimensions() const;
  Place PlaceEdgeInSolid(Id edge) const;
  Place PlaceVertexInSurface(Id vertex) const;
  Place PlaceVertexInSolid(Id vertex, const Buffer<Place>& edgePlaces) const;
  bool IsConnectedAround(Id edge, vtkIdType faces) const;
  bool IsOneFan(Id vertex, Id start, vtkIdType edges) const;

  const Buffer<unsigned char> Dimensions; ///< of edges
};

template <typename Id>
template <typename Accept>
int Links<Id>::CountPieces(Id vertex, const Accept& accept) const
{
  const Row<Id> edges = this->VertexEdges[vertex];
  static thread_local std::vector<vtkIdType> parents; // reused by all calls
  parents.assign(edges.size(), -1);                   // -1: on no accepted face
  auto root = [](vtkIdType i)
  {
    while (parents[i] != i)
    {
      i = parents[i] = parents[parents[i]];
    }
    return i;
  };
  int pieces = 0;
  auto touch = [&](vtkIdType i)
  {
    if (parents[i] < 0)
    {
      parents[i] = i;
      ++pieces;
    }
  };
  for (vtkIdType i = 0; i < edges.size(); ++i)
  {
    const Id edge = edges.begin()[i];
    const Id far = this->Complex.GetOtherEnd(edge, vertex);
    for (Id face : this->EdgeFaces[edge])
    {
      if (!accept(face))
      {
        continue;
      }
      const Id* faceEdges = this->Complex.FaceEdges.data() + 3 * face;
      const Id other =
        faceEdges[(this->Complex.VertexInFace(face, far) + 1) % 3]; // the edge opposite to far
      const vtkIdType j = std::lower_bound(edges.begin(), edges.end(), other) - edges.begin();
      touch(i);
      touch(j);
      const vtkIdType a = root(i);
      const vtkIdType b = root(j);
      if (a != b)
      {
        parents[std::max(a, b)] = std::min(a, b);
        --pieces;
      }
    }
  }
  return pieces;
}

template <typename Id>
template <typename Accept>
bool Links<Id>::IsClosedFan(Id vertex, const Accept& accept) const
{
  for (Id edge : this->VertexEdges[vertex])
  {
    int count = 0;
    for (Id face : this->EdgeFaces[edge])
    {
      count += accept(face) ? 1 : 0;
    }
    if (count != 0 && count != 2)
    {
      return false;
    }
  }
  return this->CountPieces(vertex, accept) == 1;
}

}

#endif
