// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidShapes.h
 * The shapes of solids, and how each is split, as tables that the compiler works out.
 *
 * The *lattice points* of a solid are its vertices, then the midpoints of its edges, then, if it
 * has one, its centre. All edges are halved and all faces, which are triangles, are split into
 * four. So a shape only describes its inside: a struct with
 *  - Shapes, the ShapeList of the scheme, and Index, its position there;
 *  - the numbers Vertices, Edges, Faces, and Centres (1 if its centre is a vertex of the next
 * level, otherwise 0);
 *  - EdgeVertices, EdgeOf and FaceVertices as in tetrahedron (Simplices.h), and FaceOf(a, b, c),
 * the face with these local vertices in any order;
 *  - GetChildren(shape), for each shape of the scheme: its children of this shape, by lattice
 * points;
 *  - GetInnerEdges() and GetInnerFaces(): the edges and faces of the next level inside the solid,
 *    by lattice points, that lie in none of its edges and faces.
 * The edges and faces of children, and the children at a face, follow from these.
 */
#ifndef SubdivisionObjects_SolidShapes_h
#define SubdivisionObjects_SolidShapes_h

#include "Core/Solids/Complex/Simplices.h"

#include <array>
#include <cstddef>

namespace subdivision
{

template <typename... Shape>
struct ShapeList
{
  static constexpr int Size = sizeof...(Shape);
};

/// act(shape) for each shape of a list, in order.
template <typename... Shape, typename Act>
constexpr void ForShapes(ShapeList<Shape...>, const Act& act)
{
  (act(Shape()), ...);
}

/// The tables of tetrahedra that do not depend on how they are split.
struct TetrahedronShape
{
  static constexpr int Vertices = 4;
  static constexpr int Edges = 6;
  static constexpr int Faces = 4;
  static constexpr int Centres = 0;
  static constexpr const auto& EdgeVertices = tetrahedron::EdgeVertices;
  static constexpr const auto& EdgeOf = tetrahedron::EdgeOf;
  static constexpr const auto& FaceVertices = tetrahedron::FaceVertices;
  static constexpr int FaceOf(int a, int b, int c) { return 6 - a - b - c; }
};

/// The number of lattice points.
template <typename Shape>
constexpr int PointsOf = Shape::Vertices + Shape::Edges + Shape::Centres;
template <typename Shape>
constexpr int InnerEdgesOf = static_cast<int>(Shape::GetInnerEdges().size());
template <typename Shape>
constexpr int InnerFacesOf = static_cast<int>(Shape::GetInnerFaces().size());
template <typename Shape, typename Child>
constexpr int ChildrenOf = static_cast<int>(Shape::GetChildren(Child()).size());

/// The numbers of children of a solid by their shapes.
template <typename Shape, typename... Child>
constexpr std::array<int, sizeof...(Child)> CountChildren(ShapeList<Child...>)
{
  return { ChildrenOf<Shape, Child>... };
}
template <typename Shape>
constexpr auto NumbersOfChildren = CountChildren<Shape>(typename Shape::Shapes());

/// The lattice point between two vertices, or the vertex itself.
template <typename Shape>
constexpr int LatticePoint(int a, int b)
{
  return a == b ? a : Shape::Vertices + Shape::EdgeOf[a][b];
}

/// The *place* of an edge between two lattice points: first the two halves of each edge, then the
/// three edges inside each face, in the order of the corners that they cut off, then the inner
/// ones.
template <typename Shape>
constexpr int PlaceOfEdge(int p, int q)
{
  const auto isPair = [p, q](int a, int b) { return (p == a && q == b) || (p == b && q == a); };
  for (int e = 0; e < Shape::Edges; ++e)
  {
    for (int end = 0; end < 2; ++end)
    {
      if (isPair(Shape::EdgeVertices[e][end], Shape::Vertices + e))
      {
        return 2 * e + end;
      }
    }
  }
  for (int f = 0; f < Shape::Faces; ++f)
  {
    const auto& corners = Shape::FaceVertices[f];
    for (int i = 0; i < 3; ++i)
    {
      if (isPair(LatticePoint<Shape>(corners[i], corners[(i + 1) % 3]),
            LatticePoint<Shape>(corners[i], corners[(i + 2) % 3])))
      {
        return 2 * Shape::Edges + 3 * f + i;
      }
    }
  }
  int place = 2 * Shape::Edges + 3 * Shape::Faces;
  for (const auto& inner : Shape::GetInnerEdges())
  {
    if (isPair(inner[0], inner[1]))
    {
      return place;
    }
    ++place;
  }
  return -1;
}

/// The place of a triangle of three lattice points: for each face its parts at the three corners
/// and the middle one, then the inner ones.
template <typename Shape>
constexpr int PlaceOfFace(int p, int q, int r)
{
  const auto has = [p, q, r](int a) { return a == p || a == q || a == r; };
  for (int f = 0; f < Shape::Faces; ++f)
  {
    const auto& corners = Shape::FaceVertices[f];
    int middles[3] = { 0, 0, 0 }; // opposite to the corners
    for (int i = 0; i < 3; ++i)
    {
      middles[i] = LatticePoint<Shape>(corners[(i + 1) % 3], corners[(i + 2) % 3]);
    }
    for (int i = 0; i < 3; ++i)
    {
      if (has(corners[i]) && has(middles[(i + 1) % 3]) && has(middles[(i + 2) % 3]))
      {
        return 4 * f + i;
      }
    }
    if (has(middles[0]) && has(middles[1]) && has(middles[2]))
    {
      return 4 * f + 3;
    }
  }
  int place = 4 * Shape::Faces;
  for (const auto& inner : Shape::GetInnerFaces())
  {
    if (has(inner[0]) && has(inner[1]) && has(inner[2]))
    {
      return place;
    }
    ++place;
  }
  return -1;
}

/// The children of one shape in a solid: their lattice points, and the places of their edges and
/// faces.
template <typename Shape, typename Child>
struct ChildTable
{
  static constexpr std::size_t Size = Shape::GetChildren(Child()).size();
  std::array<std::array<int, Child::Vertices>, Size> Points{};
  std::array<std::array<int, Child::Edges>, Size> Edges{};
  std::array<std::array<int, Child::Faces>, Size> Faces{};

  constexpr ChildTable()
    : Points(Shape::GetChildren(Child()))
  {
    for (std::size_t c = 0; c < Size; ++c)
    {
      const auto& points = this->Points[c];
      for (int e = 0; e < Child::Edges; ++e)
      {
        const auto& ends = Child::EdgeVertices[e];
        this->Edges[c][e] = PlaceOfEdge<Shape>(points[ends[0]], points[ends[1]]);
      }
      for (int f = 0; f < Child::Faces; ++f)
      {
        const auto& corners = Child::FaceVertices[f];
        this->Faces[c][f] =
          PlaceOfFace<Shape>(points[corners[0]], points[corners[1]], points[corners[2]]);
      }
    }
  }
};
template <typename Shape, typename Child>
constexpr ChildTable<Shape, Child> Children{};

/// A child of a solid: the index of its shape, and its number among the children of this shape.
struct ChildSolid
{
  int Shape = -1;
  int Child = -1;
};

/// The children at the parts of faces, and at the inner faces.
template <typename Shape>
struct FaceTable
{
  static constexpr int Inner = InnerFacesOf<Shape>;
  ChildSolid AtCorners[Shape::Faces][Shape::Vertices]{}; ///< at a vertex of a face
  ChildSolid AtMiddles[Shape::Faces]{};
  std::array<std::array<int, 3>, Inner> InnerEdges{}; ///< places of the edges of an inner face
  ChildSolid AtInner[Inner][2]{};

  constexpr FaceTable()
  {
    ForShapes(typename Shape::Shapes(), [this](auto child) { this->Add(child); });
    const auto faces = Shape::GetInnerFaces();
    for (int f = 0; f < Inner; ++f)
    {
      constexpr int edges[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
      for (int i = 0; i < 3; ++i)
      {
        this->InnerEdges[f][i] = PlaceOfEdge<Shape>(faces[f][edges[i][0]], faces[f][edges[i][1]]);
      }
    }
  }

private:
  template <typename Child>
  constexpr void Add(Child)
  {
    for (int c = 0; c < ChildrenOf<Shape, Child>; ++c)
    {
      for (int place : Children<Shape, Child>.Faces[c])
      {
        const int face = place / 4;
        const int part = place % 4;
        ChildSolid* at = nullptr;
        if (face >= Shape::Faces)
        {
          ChildSolid* both = this->AtInner[place - 4 * Shape::Faces];
          at = both[0].Shape < 0 ? both : both + 1;
        }
        else
        {
          at = part == 3 ? this->AtMiddles + face
                         : this->AtCorners[face] + Shape::FaceVertices[face][part];
        }
        at->Shape = Child::Index;
        at->Child = c;
      }
    }
  }
};
template <typename Shape>
constexpr FaceTable<Shape> FacesIn{};

}

#endif
