// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/TetOctPieces.h"

#include "Core/Solids/TetOct/TetOctCells.h"
#include "Core/Solids/TetOct/TetOctTables.h"

#include <cstddef>

namespace subdivision
{
namespace
{

using Place = TetOctPieces::Place;
using Solid = TetOctPieces::Solid;

/// In cells of the output; an octahedron counts as four.
int CountCells(bool isOct, int steps)
{
  return (isOct ? 4 : 1) << (3 * steps);
}

template <typename Shape>
void Split(const Solid& solid, int steps, std::vector<Solid>& solids);

void SplitAny(const Solid& solid, int steps, std::vector<Solid>& solids)
{
  if (steps == 0)
  {
    solids.push_back(solid);
  }
  else if (solid.IsOct)
  {
    Split<OctShape>(solid, steps, solids);
  }
  else
  {
    Split<TetShape>(solid, steps, solids);
  }
}

/// Adds the solids that some steps make of a solid. Children are written in the order of
/// TetOctCells.h: first the ones of the parent's own shape.
template <typename Shape>
void Split(const Solid& solid, int steps, std::vector<Solid>& solids)
{
  std::array<Place, PointsOf<Shape>> lattice{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int v = 0; v < Shape::Vertices; ++v)
    {
      lattice[v][axis] = solid.Corners[v][axis];
    }
    for (int e = 0; e < Shape::Edges; ++e)
    {
      const auto& ends = Shape::EdgeVertices[e];
      lattice[Shape::Vertices + e][axis] =
        (solid.Corners[ends[0]][axis] + solid.Corners[ends[1]][axis]) / 2;
    }
    for (int c = 0; c < Shape::Centres; ++c)
    {
      lattice[Shape::Vertices + Shape::Edges][axis] =
        (solid.Corners[0][axis] + solid.Corners[1][axis]) / 2;
    }
  }
  int next = solid.FirstCell;
  const auto add = [&](const auto& children, bool areOcts)
  {
    for (const auto& child : children)
    {
      Solid made{ areOcts, next, {} };
      for (std::size_t k = 0; k < child.size(); ++k)
      {
        made.Corners[k] = lattice[child[k]];
      }
      SplitAny(made, steps - 1, solids);
      next += CountCells(areOcts, steps - 1);
    }
  };
  if (solid.IsOct)
  {
    add(Children<Shape, OctShape>.Points, true);
    add(Children<Shape, TetShape>.Points, false);
  }
  else
  {
    add(Children<Shape, TetShape>.Points, false);
    add(Children<Shape, OctShape>.Points, true);
  }
}

TetOctPieces Make(bool isOct, int steps)
{
  constexpr int all = TetOctPieces::Divisions;
  Solid whole{ isOct, 0, {} };
  for (int v = 0; v < whole.CountCorners(); ++v)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      whole.Corners[v][axis] = isOct ? all * TetOctPieces::GetVertex(v)[axis]
        : v == axis + 1              ? all
                                     : 0;
    }
  }
  TetOctPieces made;
  SplitAny(whole, steps, made.Solids);
  return made;
}

TetOctPieces::QuarterTable MakeQuarters()
{
  const int vertices[6] = { 0, 1, 2, 3, 4, 5 };
  int tets[16];
  CutOctahedron(vertices, 0, tets);
  TetOctPieces::QuarterTable quarters{};
  for (int i = 0; i < 16; ++i)
  {
    quarters[i / 4][i % 4] = tets[i];
  }
  return quarters;
}

}

const TetOctPieces& TetOctPieces::Get(bool isOct, int steps)
{
  static const std::vector<TetOctPieces> all = []()
  {
    std::vector<TetOctPieces> made;
    for (int s = 0; s <= Steps; ++s)
    {
      made.push_back(Make(false, s));
      made.push_back(Make(true, s));
    }
    return made;
  }();
  return all[static_cast<std::size_t>(2 * steps + (isOct ? 1 : 0))];
}

const TetOctPieces::QuarterTable& TetOctPieces::GetQuarters()
{
  static const QuarterTable quarters = MakeQuarters();
  return quarters;
}

TetOctPieces::Place TetOctPieces::GetVertex(int vertex)
{
  Place place{};
  place[vertex / 2] = vertex % 2 == 0 ? 1 : -1;
  return place;
}

std::array<vtkIdType, 6> TetOctPieces::Join(const vtkIdType* quarters)
{
  std::array<vtkIdType, 6> vertices{};
  JoinOctahedron(quarters, vertices.data());
  return vertices;
}

}
