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
#include "Core/Solids/Scheme/SolidShapes.h"

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

/// The shapes of the scheme (SolidShapes.h): a tetrahedron is split into a tetrahedron at each
/// vertex and an octahedron between; an octahedron into an octahedron at each vertex, half as
/// large, and a tetrahedron from each face to the centre.
struct TetShape;
struct OctShape;

struct TetShape : TetrahedronShape
{
  using Shapes = ShapeList<TetShape, OctShape>;
  static constexpr int Index = 0;

  static constexpr std::array<std::array<int, 4>, 4> GetChildren(TetShape);
  static constexpr std::array<std::array<int, 6>, 1> GetChildren(OctShape);
  static constexpr std::array<std::array<int, 2>, 0> GetInnerEdges() { return {}; }
  /// Face v cuts off vertex v.
  static constexpr std::array<std::array<int, 3>, 4> GetInnerFaces();
};

struct OctShape
{
  using Shapes = TetShape::Shapes;
  static constexpr int Index = 1;
  static constexpr int Vertices = 6;
  static constexpr int Edges = 12;
  static constexpr int Faces = 8;
  static constexpr int Centres = 1;
  static constexpr int Centre = Vertices + Edges; ///< as lattice point
  static constexpr const auto& EdgeVertices = octahedron::EdgeVertices;
  static constexpr const auto& EdgeOf = octahedron::EdgeOf;
  static constexpr const auto& FaceVertices = octahedron::FaceVertices;
  static constexpr int FaceOf(int a, int b, int c) { return octahedron::FaceOf(a, b, c); }

  static constexpr std::array<std::array<int, 4>, 8> GetChildren(TetShape);
  static constexpr std::array<std::array<int, 6>, 6> GetChildren(OctShape);
  /// Spoke e joins the centre and the midpoint of edge e.
  static constexpr std::array<std::array<int, 2>, 12> GetInnerEdges();
  /// Face 3k + i joins the centre and the edge that cuts corner i off face k.
  static constexpr std::array<std::array<int, 3>, 24> GetInnerFaces();
};

constexpr std::array<std::array<int, 4>, 4> TetShape::GetChildren(TetShape)
{
  std::array<std::array<int, 4>, 4> tets{};
  for (int v = 0; v < 4; ++v)
  {
    for (int w = 0; w < 4; ++w)
    {
      tets[v][w] = LatticePoint<TetShape>(v, w);
    }
  }
  return tets;
}

constexpr std::array<std::array<int, 6>, 1> TetShape::GetChildren(OctShape)
{
  constexpr int pairs[6][2] = { { 0, 1 }, { 2, 3 }, { 0, 3 }, { 1, 2 }, { 0, 2 }, { 1, 3 } };
  std::array<std::array<int, 6>, 1> octs{};
  for (int w = 0; w < 6; ++w)
  {
    octs[0][w] = LatticePoint<TetShape>(pairs[w][0], pairs[w][1]);
  }
  return octs;
}

constexpr std::array<std::array<int, 3>, 4> TetShape::GetInnerFaces()
{
  std::array<std::array<int, 3>, 4> faces{};
  for (int v = 0; v < 4; ++v)
  {
    for (int i = 0; i < 3; ++i)
    {
      faces[v][i] = LatticePoint<TetShape>(v, tetrahedron::FaceVertices[v][i]);
    }
  }
  return faces;
}

constexpr std::array<std::array<int, 4>, 8> OctShape::GetChildren(TetShape)
{
  std::array<std::array<int, 4>, 8> tets{};
  for (int f = 0; f < 8; ++f)
  {
    tets[f][0] = Centre;
    for (int i = 0; i < 3; ++i)
    {
      const int* face = octahedron::FaceVertices[f];
      tets[f][1 + i] = LatticePoint<OctShape>(face[i], face[(i + 1) % 3]);
    }
  }
  return tets;
}

constexpr std::array<std::array<int, 6>, 6> OctShape::GetChildren(OctShape)
{
  std::array<std::array<int, 6>, 6> octs{};
  for (int v = 0; v < 6; ++v)
  {
    for (int w = 0; w < 6; ++w)
    {
      octs[v][w] = w == octahedron::Opposite(v) ? Centre : LatticePoint<OctShape>(v, w);
    }
  }
  return octs;
}

constexpr std::array<std::array<int, 2>, 12> OctShape::GetInnerEdges()
{
  std::array<std::array<int, 2>, 12> edges{};
  for (int e = 0; e < 12; ++e)
  {
    edges[e][0] = Centre;
    edges[e][1] = Vertices + e;
  }
  return edges;
}

constexpr std::array<std::array<int, 3>, 24> OctShape::GetInnerFaces()
{
  std::array<std::array<int, 3>, 24> faces{};
  for (int f = 0; f < 8; ++f)
  {
    const int* corners = octahedron::FaceVertices[f];
    for (int i = 0; i < 3; ++i)
    {
      faces[3 * f + i][0] = Centre;
      faces[3 * f + i][1] = LatticePoint<OctShape>(corners[i], corners[(i + 1) % 3]);
      faces[3 * f + i][2] = LatticePoint<OctShape>(corners[i], corners[(i + 2) % 3]);
    }
  }
  return faces;
}

}

#endif
