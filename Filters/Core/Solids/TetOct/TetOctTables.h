// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctTables.h
 * Tetrahedra and octahedra split into each other (Mathematics 10), as tables that the compiler
 * works out.
 *
 * An octahedron is three pairs of opposite vertices, local numbers 0 1, 2 3, 4 5; it is positive if
 * det(x0 - x1, x2 - x3, x4 - x5) > 0. Its face k has of pair i the vertex 2 i + (bit i of k). The
 * *lattice points* of a cell are its vertices, then the midpoints of its edges, then, of an
 * octahedron, the centre.
 */
#ifndef SubdivisionObjects_TetOctTables_h
#define SubdivisionObjects_TetOctTables_h

#include "Core/Solids/Complex/Simplices.h"

namespace subdivision
{

namespace octahedron
{
constexpr int Opposite(int vertex)
{
  return vertex ^ 1;
}
constexpr int EdgeVertices[12][2] = { { 0, 2 }, { 0, 3 }, { 0, 4 }, { 0, 5 }, { 1, 2 }, { 1, 3 },
  { 1, 4 }, { 1, 5 }, { 2, 4 }, { 2, 5 }, { 3, 4 }, { 3, 5 } };
constexpr int EdgeOf[6][6] = { { -1, -1, 0, 1, 2, 3 }, { -1, -1, 4, 5, 6, 7 },
  { 0, 4, -1, -1, 8, 9 }, { 1, 5, -1, -1, 10, 11 }, { 2, 6, 8, 10, -1, -1 },
  { 3, 7, 9, 11, -1, -1 } };
/// Seen from outside a positive octahedron, the vertices of each face run counterclockwise.
constexpr int FaceVertices[8][3] = { { 0, 2, 4 }, { 1, 4, 2 }, { 0, 4, 3 }, { 1, 3, 4 },
  { 0, 5, 2 }, { 1, 2, 5 }, { 0, 3, 5 }, { 1, 5, 3 } };
/// The face with these vertices, one of each pair in any order.
constexpr int FaceOf(int a, int b, int c)
{
  return ((a & 1) << (a >> 1)) | ((b & 1) << (b >> 1)) | ((c & 1) << (c >> 1));
}
/// Position of a vertex in a face.
constexpr int CornerOf(int face, int vertex)
{
  const int* corners = FaceVertices[face];
  return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
}
/// The first vertex of the pair that an edge does not touch.
constexpr int ThirdPair(int a, int b)
{
  return 2 * (3 - (a >> 1) - (b >> 1));
}
/// The first of the two faces at an edge.
constexpr int FirstFaceAt(int edge)
{
  const int a = EdgeVertices[edge][0];
  const int b = EdgeVertices[edge][1];
  return FaceOf(a, b, ThirdPair(a, b));
}
}

/// The shape of a cell, to write once what tetrahedra and octahedra have in common.
struct TetShape
{
  static constexpr int Vertices = 4;
  static constexpr int Edges = 6;
  static constexpr int Faces = 4;
  static constexpr int Points = 10; ///< lattice points
  static constexpr int ChildTets = 4;
  static constexpr int ChildOcts = 1;
  static constexpr const auto& EdgeVertices = tetrahedron::EdgeVertices;
  static constexpr const auto& EdgeOf = tetrahedron::EdgeOf;
  static constexpr const auto& FaceVertices = tetrahedron::FaceVertices;
};

struct OctShape
{
  static constexpr int Vertices = 6;
  static constexpr int Edges = 12;
  static constexpr int Faces = 8;
  static constexpr int Points = 19;
  static constexpr int ChildTets = 8;
  static constexpr int ChildOcts = 6;
  static constexpr const auto& EdgeVertices = octahedron::EdgeVertices;
  static constexpr const auto& EdgeOf = octahedron::EdgeOf;
  static constexpr const auto& FaceVertices = octahedron::FaceVertices;
};

/// The lattice point between two vertices, or the vertex itself.
template <typename Shape>
constexpr int LatticePoint(int a, int b)
{
  return a == b ? a : Shape::Vertices + Shape::EdgeOf[a][b];
}

/// What an edge between two lattice points is a part of.
enum class EdgePart : unsigned char
{
  Half,   ///< Index = edge, Corner = which of its ends
  InFace, ///< Index = face, Corner = position in FaceVertices of the vertex it cuts off
  Spoke   ///< of an octahedron: from the centre to the midpoint of edge Index
};
struct ChildEdgePart
{
  EdgePart Part = EdgePart::Spoke;
  signed char Index = -1;
  signed char Corner = -1;
};

/// The position of a child edge in CellParts::Edges: first the two halves of each edge, then the
/// three edges inside each face, then the spokes.
template <typename Shape>
constexpr int PlaceOf(ChildEdgePart part)
{
  constexpr int inFaces = 2 * Shape::Edges;
  return part.Part == EdgePart::Half ? 2 * part.Index + part.Corner
    : part.Part == EdgePart::InFace  ? inFaces + 3 * part.Index + part.Corner
                                     : inFaces + 3 * Shape::Faces + part.Index;
}

/// What a triangle between three lattice points is a part of.
enum class FacePart : unsigned char
{
  Corner,  ///< Index = face, Corner = position in FaceVertices
  Middle,  ///< Index = face
  Interior ///< of a tetrahedron: cuts off vertex Index; of an octahedron: spanned by the centre and
           ///< the edge that cuts corner Corner off face Index
};
struct ChildFacePart
{
  FacePart Part = FacePart::Interior;
  signed char Index = -1;
  signed char Corner = -1;
};

template <typename Shape>
constexpr bool FaceHas(int face, int vertex)
{
  return Shape::FaceVertices[face][0] == vertex || Shape::FaceVertices[face][1] == vertex ||
    Shape::FaceVertices[face][2] == vertex;
}

template <typename Shape>
constexpr bool FaceHasEdge(int face, int edge)
{
  return FaceHas<Shape>(face, Shape::EdgeVertices[edge][0]) &&
    FaceHas<Shape>(face, Shape::EdgeVertices[edge][1]);
}

template <typename Shape>
constexpr ChildEdgePart ClassifyChildEdge(int p, int q)
{
  if (p > q)
  {
    return ClassifyChildEdge<Shape>(q, p);
  }
  constexpr int centre = Shape::Vertices + Shape::Edges;
  ChildEdgePart part;
  const int first = p - Shape::Vertices;
  const int second = q - Shape::Vertices;
  if (p < Shape::Vertices)
  {
    part.Part = EdgePart::Half;
    part.Index = static_cast<signed char>(second);
    part.Corner = Shape::EdgeVertices[second][1] == p ? 1 : 0;
    return part;
  }
  if (q == centre)
  {
    part.Index = static_cast<signed char>(first);
    return part;
  }
  part.Part = EdgePart::InFace;
  for (int face = 0; face < Shape::Faces; ++face)
  {
    if (FaceHasEdge<Shape>(face, first) && FaceHasEdge<Shape>(face, second))
    {
      part.Index = static_cast<signed char>(face);
      for (int corner = 0; corner < 3; ++corner)
      {
        const int vertex = Shape::FaceVertices[face][corner];
        if ((Shape::EdgeVertices[first][0] == vertex || Shape::EdgeVertices[first][1] == vertex) &&
          (Shape::EdgeVertices[second][0] == vertex || Shape::EdgeVertices[second][1] == vertex))
        {
          part.Corner = static_cast<signed char>(corner);
        }
      }
    }
  }
  return part;
}

template <typename Shape>
constexpr ChildFacePart ClassifyChildFace(int p, int q, int r)
{
  constexpr int centre = Shape::Vertices + Shape::Edges;
  ChildFacePart part;
  const int points[3] = { p, q, r };
  for (int i = 0; i < 3; ++i)
  {
    if (points[i] < Shape::Vertices || points[i] == centre)
    {
      const ChildEdgePart cut = ClassifyChildEdge<Shape>(points[(i + 1) % 3], points[(i + 2) % 3]);
      part.Part = points[i] == centre ? FacePart::Interior : FacePart::Corner;
      part.Index = cut.Index;
      part.Corner = cut.Corner;
      return part;
    }
  }
  for (int face = 0; face < Shape::Faces; ++face)
  {
    if (FaceHasEdge<Shape>(face, p - Shape::Vertices) &&
      FaceHasEdge<Shape>(face, q - Shape::Vertices) &&
      FaceHasEdge<Shape>(face, r - Shape::Vertices))
    {
      part.Part = FacePart::Middle;
      part.Index = static_cast<signed char>(face);
      return part;
    }
  }
  for (int vertex = 0; vertex < Shape::Vertices; ++vertex) // of a tetrahedron
  {
    bool all = true;
    for (int point : points)
    {
      const int* ends = Shape::EdgeVertices[point - Shape::Vertices];
      all = all && (ends[0] == vertex || ends[1] == vertex);
    }
    part.Index = all ? static_cast<signed char>(vertex) : part.Index;
  }
  return part;
}

/// The children of a cell: which lattice points they have, and what their edges (PlaceOf) and faces
/// are.
template <typename Shape>
struct ChildTable
{
  std::array<std::array<int, 4>, Shape::ChildTets> Tets{};
  std::array<std::array<int, 6>, Shape::ChildOcts> Octs{};
  std::array<std::array<int, 6>, Shape::ChildTets> TetEdges{};
  std::array<std::array<ChildFacePart, 4>, Shape::ChildTets> TetFaces{};
  std::array<std::array<int, 12>, Shape::ChildOcts> OctEdges{};
  std::array<std::array<ChildFacePart, 8>, Shape::ChildOcts> OctFaces{};

  constexpr ChildTable()
  {
    this->SetCorners();
    for (int c = 0; c < Shape::ChildTets; ++c)
    {
      this->Classify<TetShape>(this->Tets[c], this->TetEdges[c], this->TetFaces[c]);
    }
    for (int c = 0; c < Shape::ChildOcts; ++c)
    {
      this->Classify<OctShape>(this->Octs[c], this->OctEdges[c], this->OctFaces[c]);
    }
  }

private:
  constexpr void SetCorners()
  {
    if constexpr (Shape::Vertices == 4) // a tetrahedron at each vertex, the octahedron in between
    {
      for (int v = 0; v < 4; ++v)
      {
        for (int w = 0; w < 4; ++w)
        {
          this->Tets[v][w] = LatticePoint<Shape>(v, w);
        }
      }
      const int pairs[6][2] = { { 0, 1 }, { 2, 3 }, { 0, 3 }, { 1, 2 }, { 0, 2 }, { 1, 3 } };
      for (int w = 0; w < 6; ++w)
      {
        this->Octs[0][w] = LatticePoint<Shape>(pairs[w][0], pairs[w][1]);
      }
    }
    else // an octahedron at each vertex, half as large; a tetrahedron from each face to the centre
    {
      constexpr int centre = Shape::Vertices + Shape::Edges;
      for (int v = 0; v < 6; ++v)
      {
        for (int w = 0; w < 6; ++w)
        {
          this->Octs[v][w] = w == octahedron::Opposite(v) ? centre : LatticePoint<Shape>(v, w);
        }
      }
      for (int f = 0; f < 8; ++f)
      {
        this->Tets[f][0] = centre;
        for (int i = 0; i < 3; ++i)
        {
          const int* face = octahedron::FaceVertices[f];
          this->Tets[f][1 + i] = LatticePoint<Shape>(face[i], face[(i + 1) % 3]);
        }
      }
    }
  }

  template <typename Child, typename Corners, typename Edges, typename Faces>
  constexpr void Classify(const Corners& corners, Edges& edges, Faces& faces)
  {
    for (int e = 0; e < Child::Edges; ++e)
    {
      edges[e] = PlaceOf<Shape>(ClassifyChildEdge<Shape>(
        corners[Child::EdgeVertices[e][0]], corners[Child::EdgeVertices[e][1]]));
    }
    for (int f = 0; f < Child::Faces; ++f)
    {
      faces[f] = ClassifyChildFace<Shape>(corners[Child::FaceVertices[f][0]],
        corners[Child::FaceVertices[f][1]], corners[Child::FaceVertices[f][2]]);
    }
  }
};
template <typename Shape>
constexpr ChildTable<Shape> Children{};

}

#endif
