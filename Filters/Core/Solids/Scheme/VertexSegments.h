// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VertexSegments.h
 * The order in which a level of solids numbers its vertices (IdSegments.h).
 */
#ifndef SubdivisionObjects_VertexSegments_h
#define SubdivisionObjects_VertexSegments_h

#include "Core/Memory/IdSegments.h"
#include "Core/Solids/Scheme/SolidShapes.h"

#include <array>

namespace subdivision
{

/// The vertices of a level, `steps` steps after the control level, of a scheme that splits its
/// solids by tables; kinds are dimensions of control simplices. Follows the arithmetic of ChildIds
/// (SolidParts.h), in which the children of an entity are consecutive, and have the order of their
/// parents. Takes time and memory for 2^steps segments.
template <typename Shapes>
IdSegments ListVertexSegments(int steps)
{
  IdSegments vertices{ { 0, 1, {} } };
  IdSegments edges{ { 1, 1, {} } };
  IdSegments faces{ { 2, 1, {} } };
  std::array<IdSegments, Shapes::Size> solids{ IdSegments{
    { 3, 1, {} } } }; // tetrahedra are the first shape
  for (int step = 0; step < steps; ++step)
  {
    AppendChildren(edges, 1, vertices);
    IdSegments nextEdges;
    IdSegments nextFaces;
    std::array<IdSegments, Shapes::Size> nextSolids;
    AppendChildren(edges, 2, nextEdges);
    AppendChildren(faces, 3, nextEdges);
    AppendChildren(faces, 4, nextFaces);
    ForShapes(Shapes(),
      [&](auto shape)
      {
        using Shape = decltype(shape);
        const auto append = [&](IdSegments& list, int children)
        {
          if (children > 0)
          {
            AppendChildren(solids[Shape::Index], children, list);
          }
        };
        append(vertices, Shape::Centres);
        append(nextEdges, InnerEdgesOf<Shape>);
        append(nextFaces, InnerFacesOf<Shape>);
        for (int child = 0; child < Shapes::Size; ++child)
        {
          append(nextSolids[child], NumbersOfChildren<Shape>[child]);
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
