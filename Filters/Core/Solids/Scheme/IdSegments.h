// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IdSegments.h
 * The order in which a level numbers its vertices, told by what they come from on the control
 * level.
 */
#ifndef SubdivisionObjects_IdSegments_h
#define SubdivisionObjects_IdSegments_h

#include "Core/Solids/Scheme/SolidShapes.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace subdivision
{

/// Consecutive ids: first those of what the first control simplex of a dimension becomes, then
/// those of the second one, and so on, the same number for each.
struct IdSegment
{
  int Dimension;
  vtkIdType OfEach;
};

/// The vertices of a level, `steps` steps after the control level, of a scheme that splits its
/// solids by tables. Follows the arithmetic of ChildIds (SolidParts.h), in which the children of an
/// entity are consecutive, and have the order of their parents. Takes time and memory for 2^steps
/// segments.
template <typename Shapes>
std::vector<IdSegment> ListVertexSegments(int steps)
{
  using List = std::vector<IdSegment>;
  const auto append = [](List& list, const List& parents, int children)
  {
    for (const IdSegment& parent : parents)
    {
      if (children > 0)
      {
        list.push_back({ parent.Dimension, children * parent.OfEach });
      }
    }
  };
  List vertices{ { 0, 1 } };
  List edges{ { 1, 1 } };
  List faces{ { 2, 1 } };
  std::array<List, Shapes::Size> solids{ List{ { 3, 1 } } }; // tetrahedra are the first shape
  for (int step = 0; step < steps; ++step)
  {
    append(vertices, edges, 1);
    List nextEdges;
    List nextFaces;
    std::array<List, Shapes::Size> nextSolids;
    append(nextEdges, edges, 2);
    append(nextEdges, faces, 3);
    append(nextFaces, faces, 4);
    ForShapes(Shapes(),
      [&](auto shape)
      {
        using Shape = decltype(shape);
        const List& parents = solids[Shape::Index];
        append(vertices, parents, Shape::Centres);
        append(nextEdges, parents, InnerEdgesOf<Shape>);
        append(nextFaces, parents, InnerFacesOf<Shape>);
        for (int child = 0; child < Shapes::Size; ++child)
        {
          append(nextSolids[child], parents, NumbersOfChildren<Shape>[child]);
        }
      });
    edges = std::move(nextEdges);
    faces = std::move(nextFaces);
    solids = std::move(nextSolids);
  }
  return vertices;
}

}

#endif
