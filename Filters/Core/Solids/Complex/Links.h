// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Links.h
 * The links of vertices and edges inside one C_k. A link tells whether the vertex or edge is
 * interior, on the boundary, or non-manifold (the table of Mathematics 3).
 */
#ifndef SubdivisionObjects_Links_h
#define SubdivisionObjects_Links_h

#include "Core/Solids/Complex/SimplicialComplex.h"

#include <algorithm>
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

// What links ask of a complex; CellComplex.h has the same for its own.

/// At an edge faces, and at a vertex edges, that form a cycle are so many at least.
template <typename Id>
vtkIdType GetLeastCycle(const SimplicialComplex<Id>&)
{
  return 3;
}
template <typename Id>
Row<Id> GetSolidsAt(const SimplicialComplex<Id>& complex, Id face)
{
  return complex.FaceTets[face];
}
/// The other edge of a face at a vertex; `far` is the other end of the first.
template <typename Id>
Id GetOtherEdge(const SimplicialComplex<Id>& complex, Id face, Id, Id, Id far)
{
  const Id* edges = complex.FaceEdges.data() + 3 * vtkIdType(face);
  return edges[triangle::EdgeOpposite[complex.VertexInFace(face, far)]];
}
/// The vertex of a triangle that does not lie on one of its edges; -1 for other faces.
template <typename Id>
Id GetOppositeVertex(const SimplicialComplex<Id>& complex, Id face, Id edge)
{
  return complex.VertexOpposite(face, edge);
}
/// The other face of a solid at an edge of a face; -1: none.
template <typename Id>
Id GetOtherFace(const SimplicialComplex<Id>& complex, Id tet, Id face, Id edge)
{
  const int local = complex.VertexInTet(tet, complex.VertexOpposite(face, edge));
  return complex.TetFaces[4 * vtkIdType(tet) + local];
}
/// The number of solids at a vertex; there are that many ends of faces at its edges, twice each
/// face, and `ends` of these on the boundary. A tetrahedron is at three faces.
template <typename Id>
vtkIdType CountSolidsAt(const SimplicialComplex<Id>&, Id, vtkIdType twiceFaces, vtkIdType ends)
{
  return (2 * twiceFaces - ends) / 6;
}

/// The set of dimensions k for which an edge lies in C_k, as DimensionBit, and how it lies in C_2
/// and C_3.
struct EdgeFacts
{
  unsigned char Dimensions = 0;
  Place InSurface = Place::Outside;
  Place InSolid = Place::Outside;
};

/// Of a SimplicialComplex or a CellComplex (Core/Cells).
template <typename Id, typename AnyComplex = SimplicialComplex<Id>>
class Links
{
public:
  explicit Links(const AnyComplex& complex);
  Links(const Links&) = delete;
  Links& operator=(const Links&) = delete;

  const AnyComplex& Complex;
  const Rows<Id> VertexEdges; ///< all edges at a vertex, in order

private:
  const Rows<Id> OwnFaces; ///< where the complex has no EdgeFaces

public:
  const Rows<Id>& EdgeFaces; ///< all faces at an edge, in order

  /// The set of dimensions k for which a simplex lies in C_k, as DimensionBit.
  unsigned char FaceDimension(Id face) const
  {
    return DimensionBit(GetSolidsAt(this->Complex, face).size() > 0 ? 3 : 2);
  }
  unsigned char EdgeDimensions(Id edge) const { return this->Facts[edge].Dimensions; }
  unsigned char VertexDimensions(Id vertex) const;
  /// The dimension that all simplices lie in, as DimensionBit; 0: there are several.
  unsigned char GetOnlyDimension() const { return this->OnlyDimension; }

  /// How an edge lies in C_k.
  Place PlaceEdge(Id edge, int k) const
  {
    const EdgeFacts& facts = this->Facts[edge];
    return k == 3                          ? facts.InSolid
      : k == 2                             ? facts.InSurface
      : facts.Dimensions & DimensionBit(1) ? Place::Interior
                                           : Place::Outside;
  }

  /// How a vertex lies in C_k.
  Place PlaceVertex(Id vertex, int k) const;

  /// Whether the faces at a vertex that `accept` takes form one closed fan around it.
  template <typename Accept>
  bool IsClosedFan(Id vertex, const Accept& accept) const;

private:
  unsigned char FindOnlyDimension() const;
  Buffer<EdgeFacts> FindFacts() const;
  EdgeFacts FindFacts(Id edge) const;
  Place PlaceVertexInSurface(Id vertex) const;
  Place PlaceVertexInSolid(Id vertex) const;
  bool IsConnectedAround(Id edge, vtkIdType faces, bool isClosed) const;
  bool IsOneFan(Id vertex, Id start, vtkIdType edges, bool isClosed) const;
  template <typename Accept>
  bool IsOnePiece(Id vertex, Id start, vtkIdType nodes, const Accept& accept) const;

  const unsigned char OnlyDimension;
  const Buffer<EdgeFacts> Facts; ///< of edges
};

/// Whether a graph has one piece only: its nodes are the edges at a vertex that lie on accepted
/// faces, one of them `start`, and its arcs are these faces. Each node must be on a cycle, so that
/// the search may stop before the last ones.
template <typename Id, typename AnyComplex>
template <typename Accept>
bool Links<Id, AnyComplex>::IsOnePiece(
  Id vertex, Id start, vtkIdType nodes, const Accept& accept) const
{
  const Row<Id> edges = this->VertexEdges[vertex];
  const auto find = [&edges](Id edge) // without branches, which the processor would mispredict
  {
    const Id* place = edges.begin();
    for (vtkIdType size = edges.size(); size > 1;)
    {
      const vtkIdType half = size / 2;
      place += place[half] <= edge ? half : 0;
      size -= half;
    }
    return place - edges.begin();
  };
  constexpr vtkIdType few = 64;
  unsigned char fewMet[few] = {};
  Id fewToVisit[few];
  const vtkIdType many = edges.size() > few ? edges.size() : 0;
  std::vector<unsigned char> manyMet(static_cast<std::size_t>(many), 0);
  std::vector<Id> manyToVisit(static_cast<std::size_t>(many));
  unsigned char* const areMet = many > 0 ? manyMet.data() : fewMet; // for each edge at the vertex
  Id* const toVisit = many > 0 ? manyToVisit.data() : fewToVisit;
  vtkIdType left = 0;
  toVisit[left++] = start;
  areMet[find(start)] = 1;
  const vtkIdType rest = GetLeastCycle(this->Complex) - 1;
  vtkIdType count = 1;
  while (count + rest < nodes && left > 0)
  {
    const Id edge = toVisit[--left];
    const Id far = this->Complex.GetOtherEnd(edge, vertex);
    for (const Id face : this->EdgeFaces[edge])
    {
      if (!accept(face))
      {
        continue;
      }
      const Id other = GetOtherEdge(this->Complex, face, edge, vertex, far);
      unsigned char& isMet = areMet[find(other)];
      if (!isMet)
      {
        isMet = 1;
        ++count;
        toVisit[left++] = other;
      }
    }
  }
  return count + rest >= nodes;
}

template <typename Id, typename AnyComplex>
template <typename Accept>
bool Links<Id, AnyComplex>::IsClosedFan(Id vertex, const Accept& accept) const
{
  vtkIdType nodes = 0;
  Id start = -1;
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
    nodes += count > 0 ? 1 : 0;
    start = count > 0 ? edge : start;
  }
  return nodes > 0 && this->IsOnePiece(vertex, start, nodes, accept);
}

}

#endif
