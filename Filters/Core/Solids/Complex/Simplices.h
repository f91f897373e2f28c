// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Simplices.h
 * Ordered simplices and their children (Mathematics 2), as tables that the compiler works out.
 *
 * Local names. Edges of a triangle: 01, 12, 02. Edges of a tetrahedron: 01, 02, 03, 12, 13, 23.
 * Face i of a tetrahedron is opposite to vertex i. A *lattice point* of a simplex is one of its
 * vertices, or the midpoint of one of its edges: vertices first, then edges. The marked edges of a
 * tetrahedron are 02 and 13; the diagonal joins their midpoints.
 */
#ifndef SubdivisionObjects_Simplices_h
#define SubdivisionObjects_Simplices_h

#include <array>

namespace subdivision
{

namespace triangle
{
constexpr int EdgeVertices[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
/// The two edges at a vertex; the one whose other end has the smaller local number comes first.
constexpr int EdgesAt[3][2] = { { 0, 2 }, { 0, 1 }, { 2, 1 } };
/// The vertex opposite to an edge, and the edge opposite to a vertex.
constexpr int VertexOpposite[3] = { 2, 0, 1 };
constexpr int EdgeOpposite[3] = { 1, 2, 0 };
/// Children as lattice points: three at the vertices, then the middle one.
constexpr int Children[4][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 3, 4, 5 } };
/// The vertex that each edge of the middle child cuts off.
constexpr int MiddleEdgeCorner[3] = { 1, 2, 0 };
/// The edge that meets an edge at its first or second vertex.
constexpr int EdgeBeside[3][2] = { { 2, 1 }, { 0, 2 }, { 0, 1 } };
}

namespace tetrahedron
{
constexpr int EdgeVertices[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
constexpr int EdgeOf[4][4] = { { -1, 0, 1, 2 }, { 0, -1, 3, 4 }, { 1, 3, -1, 5 }, { 2, 4, 5, -1 } };
constexpr int FaceVertices[4][3] = { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } };
constexpr int MarkedEdges[2] = { 1, 4 };
/// The four edges whose midpoints form the equator around the diagonal.
constexpr int EquatorEdges[4] = { 0, 2, 3, 5 };
constexpr int OppositeEdge(int edge)
{
  return 5 - edge;
}
constexpr bool IsMarked(int edge)
{
  return edge == 1 || edge == 4;
}
constexpr int EquatorIndex(int edge)
{
  return edge == 0 ? 0 : edge == 2 ? 1 : edge == 3 ? 2 : 3;
}

constexpr int Children[8][4] = { { 0, 4, 5, 6 }, { 4, 1, 7, 8 }, { 5, 7, 2, 9 }, { 6, 8, 9, 3 },
  { 4, 5, 6, 8 }, { 7, 5, 4, 8 }, { 5, 6, 8, 9 }, { 8, 7, 5, 9 } };

/// The part of a tetrahedron in which an edge between two lattice points lies.
enum class EdgeOrigin : unsigned char
{
  HalfEdge, ///< Index = edge, Corner = the vertex at its end
  InFace,   ///< Index = face, Corner = the vertex of the face it cuts off
  Diagonal
};
struct ChildEdge
{
  EdgeOrigin Origin;
  signed char Index;
  signed char Corner;
};

/// The part of a tetrahedron in which a triangle between three lattice points lies.
enum class FaceOrigin : unsigned char
{
  FaceCorner, ///< Index = face, Corner = vertex
  FaceMiddle, ///< Index = face
  Interior    ///< Index = 0..3: cuts off that vertex; 4 + q: spans the diagonal and the midpoint of
              ///< EquatorEdges[q]
};
struct ChildFace
{
  FaceOrigin Origin;
  signed char Index;
  signed char Corner;
};

constexpr bool Touches(int edge, int vertex)
{
  return EdgeVertices[edge][0] == vertex || EdgeVertices[edge][1] == vertex;
}

constexpr ChildEdge ClassifyEdge(int p, int q)
{
  if (p > q)
  {
    return ClassifyEdge(q, p);
  }
  if (p < 4)
  {
    return { EdgeOrigin::HalfEdge, static_cast<signed char>(q - 4), static_cast<signed char>(p) };
  }
  const int a = p - 4;
  const int b = q - 4;
  for (int corner = 0; corner < 4; ++corner)
  {
    if (Touches(a, corner) && Touches(b, corner))
    {
      int opposite = 0;
      while (Touches(a, opposite) || Touches(b, opposite))
      {
        ++opposite;
      }
      return { EdgeOrigin::InFace, static_cast<signed char>(opposite),
        static_cast<signed char>(corner) };
    }
  }
  return { EdgeOrigin::Diagonal, 0, 0 };
}

constexpr ChildFace ClassifyFace(int p, int q, int r)
{
  const int points[3] = { p, q, r };
  for (int corner : points)
  {
    if (corner < 4) // the other two are midpoints of edges at this vertex
    {
      const int other = corner == p ? q : p;
      const int third = corner == r ? q : r;
      const ChildEdge cut = ClassifyEdge(other, third);
      return { FaceOrigin::FaceCorner, cut.Index, static_cast<signed char>(corner) };
    }
  }
  for (int vertex = 0; vertex < 4; ++vertex)
  {
    const int touching = Touches(p - 4, vertex) + Touches(q - 4, vertex) + Touches(r - 4, vertex);
    if (touching == 3)
    {
      return { FaceOrigin::Interior, static_cast<signed char>(vertex), 0 };
    }
    if (touching == 0)
    {
      return { FaceOrigin::FaceMiddle, static_cast<signed char>(vertex), 0 };
    }
  }
  const int equator = !IsMarked(p - 4) ? p - 4 : !IsMarked(q - 4) ? q - 4 : r - 4;
  return { FaceOrigin::Interior, static_cast<signed char>(4 + EquatorIndex(equator)), 0 };
}

constexpr auto MakeChildEdges()
{
  std::array<std::array<ChildEdge, 6>, 8> table{};
  for (int child = 0; child < 8; ++child)
  {
    for (int edge = 0; edge < 6; ++edge)
    {
      table[child][edge] = ClassifyEdge(
        Children[child][EdgeVertices[edge][0]], Children[child][EdgeVertices[edge][1]]);
    }
  }
  return table;
}
constexpr auto MakeChildFaces()
{
  std::array<std::array<ChildFace, 4>, 8> table{};
  for (int child = 0; child < 8; ++child)
  {
    for (int face = 0; face < 4; ++face)
    {
      table[child][face] = ClassifyFace(Children[child][FaceVertices[face][0]],
        Children[child][FaceVertices[face][1]], Children[child][FaceVertices[face][2]]);
    }
  }
  return table;
}
constexpr auto ChildEdges = MakeChildEdges();
constexpr auto ChildFaces = MakeChildFaces();

/// A triangle inside a split tetrahedron: the edges whose midpoints are its vertices, and the two
/// child tetrahedra at it. There are eight, numbered as FaceOrigin::Interior says.
struct InteriorFace
{
  int Edges[3] = { 0, 0, 0 };
  int Tets[2] = { -1, -1 };
};
constexpr auto MakeInteriorFaces()
{
  std::array<InteriorFace, 8> table{};
  for (int corner = 0; corner < 4; ++corner)
  {
    for (int i = 0; i < 3; ++i)
    {
      table[corner].Edges[i] = EdgeOf[corner][FaceVertices[corner][i]];
    }
  }
  for (int q = 0; q < 4; ++q)
  {
    table[4 + q].Edges[0] = MarkedEdges[0];
    table[4 + q].Edges[1] = MarkedEdges[1];
    table[4 + q].Edges[2] = EquatorEdges[q];
  }
  for (int child = 0; child < 8; ++child)
  {
    for (int face = 0; face < 4; ++face)
    {
      const ChildFace origin = ChildFaces[child][face];
      if (origin.Origin == FaceOrigin::Interior)
      {
        int* tets = table[origin.Index].Tets;
        tets[tets[0] < 0 ? 0 : 1] = child;
      }
    }
  }
  return table;
}
constexpr auto InteriorFaces = MakeInteriorFaces();

/// For each face the child tetrahedron that has the middle triangle of this face.
constexpr auto MakeMiddleChildren()
{
  std::array<int, 4> table{};
  for (int child = 0; child < 8; ++child)
  {
    for (int face = 0; face < 4; ++face)
    {
      if (ChildFaces[child][face].Origin == FaceOrigin::FaceMiddle)
      {
        table[ChildFaces[child][face].Index] = child;
      }
    }
  }
  return table;
}
constexpr auto MiddleChildren = MakeMiddleChildren();

/// FaceCutLinks[corner][face] is the part inside the tetrahedron of the link of a child edge: of
/// the one that cuts vertex `corner` off face `face`. The link always has the midpoint of the edge
/// from vertex `corner` to vertex `face`. If the diagonal ends on the child edge, the link has its
/// other end too.
struct FaceCutLink
{
  int CutEdge = -1;         ///< its midpoint is in the link, across interior face `corner`
  bool HasDiagonal = false; ///< then also:
  int DiagonalEdge = -1;    ///< the midpoint of this marked edge,
  int DiagonalFace = -1;    ///< across this interior face
};
constexpr auto MakeFaceCutLinks()
{
  std::array<std::array<FaceCutLink, 4>, 4> table{};
  for (int corner = 0; corner < 4; ++corner)
  {
    for (int face = 0; face < 4; ++face)
    {
      if (corner == face)
      {
        continue;
      }
      int j = 0;
      while (j == corner || j == face)
      {
        ++j;
      }
      const int k = 6 - corner - face - j;
      FaceCutLink& link = table[corner][face];
      link.CutEdge = EdgeOf[corner][face];
      const int first = EdgeOf[corner][j];
      const int second = EdgeOf[corner][k];
      link.HasDiagonal = IsMarked(first) || IsMarked(second);
      if (link.HasDiagonal)
      {
        const int touching = IsMarked(first) ? first : second;
        const int equator = IsMarked(first) ? second : first;
        link.DiagonalEdge = OppositeEdge(touching);
        link.DiagonalFace = 4 + EquatorIndex(equator);
      }
    }
  }
  return table;
}
constexpr auto FaceCutLinks = MakeFaceCutLinks();
}

}

#endif
