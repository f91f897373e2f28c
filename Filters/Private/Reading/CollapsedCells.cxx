// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/CollapsedCells.h"

#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/SolidCells.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include "vtkCellType.h"

#include <algorithm>
#include <set>
#include <utility>

namespace subdivision
{
namespace
{

using Loop = std::vector<vtkIdType>; ///< looks outwards
using Loops = std::vector<Loop>;

/// Whether b has the points of a the other way round.
bool AreOpposite(const Loop& a, Loop b)
{
  if (a.size() != b.size())
  {
    return false;
  }
  std::reverse(b.begin(), b.end());
  std::rotate(b.begin(), std::find(b.begin(), b.end(), a[0]), b.end());
  return a == b;
}

Loops::const_iterator FindOpposite(const Loops& sides, const Loop& side)
{
  return std::find_if(
    sides.begin(), sides.end(), [&side](const Loop& other) { return AreOpposite(side, other); });
}

/// Takes sides away that touch each other without a volume between: equal ones, and a quad with two
/// triangles. Returns false if there are none.
bool CloseSides(Loops& sides)
{
  for (const Loop& side : sides)
  {
    std::vector<Loops> halves = { { side } };
    for (std::size_t d = 0; d < 2 && side.size() == 4; ++d)
    {
      halves.push_back(
        { { side[d], side[d + 1], side[d + 2] }, { side[d + 2], side[(d + 3) % 4], side[d] } });
    }
    for (const Loops& parts : halves)
    {
      Loops left = sides;
      left.erase(left.begin() + (&side - sides.data()));
      for (const Loop& part : parts)
      {
        const auto found = FindOpposite(left, part);
        if (found != left.end())
        {
          left.erase(found);
        }
      }
      if (left.size() + parts.size() + 1 == sides.size())
      {
        sides = left;
        return true;
      }
    }
  }
  return false;
}

Loops FindSides(const SolidFaces& table, const vtkIdType* ids)
{
  Loops sides;
  for (int face = 0; face < table.NumberOfFaces; ++face)
  {
    const int* local = table.Faces[face];
    Loop side(local[3] < 0 ? 3 : 4);
    std::transform(local, local + side.size(), side.begin(), [ids](int i) { return ids[i]; });
    side.resize(CollapseLoop(side.data(), static_cast<vtkIdType>(side.size())));
    if (side.size() > 2 && !(side.size() == 4 && IsFolded(side.data())))
    {
      sides.push_back(side);
    }
  }
  while (CloseSides(sides))
  {
  }
  return sides;
}

/// Whether each edge of a side is the edge of one other side, which passes it the other way.
bool AreClosed(const Loops& sides)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (const Loop& side : sides)
  {
    for (std::size_t i = 0; i < side.size(); ++i)
    {
      if (!edges.insert({ side[i], side[(i + 1) % side.size()] }).second)
      {
        return false;
      }
    }
  }
  return !edges.empty() &&
    std::all_of(edges.begin(), edges.end(),
      [&edges](const auto& edge) { return edges.count({ edge.second, edge.first }) == 1; });
}

/// The tetrahedron or pyramid of a side and all others, which meet in one point; else no points.
Loop FindCone(const Loops& sides, const Loop& base)
{
  Loop cone(base.rbegin(), base.rend());
  for (const Loop& side : sides)
  {
    const auto apex = std::find_if(side.begin(), side.end(),
      [&base](vtkIdType p) { return std::find(base.begin(), base.end(), p) == base.end(); });
    const bool isBase = &side == &base;
    if (isBase != (apex == side.end()) || (!isBase && side.size() != 3) ||
      (!isBase && cone.size() > base.size() && cone.back() != *apex))
    {
      return {};
    }
    if (!isBase && cone.size() == base.size())
    {
      cone.push_back(*apex);
    }
  }
  return cone;
}

/// The wedge of a triangle, the triangle that it does not touch, and the quads between these.
Loop FindWedge(const Loops& sides, const Loop& triangle)
{
  Loop wedge(triangle);
  for (const vtkIdType corner : triangle)
  {
    for (const Loop& quad : sides)
    {
      const auto at = std::find(quad.begin(), quad.end(), corner) - quad.begin();
      if (quad.size() != 4 || at == 4)
      {
        continue;
      }
      // A quad looks outwards, too, and so passes the edges of the triangle the other way.
      const vtkIdType next = quad[(at + 1) % 4];
      if (std::find(triangle.begin(), triangle.end(), next) == triangle.end())
      {
        wedge.push_back(next);
      }
    }
  }
  const bool isWedge =
    wedge.size() == 6 && FindOpposite(sides, { wedge[3], wedge[4], wedge[5] }) != sides.end();
  return isWedge ? wedge : Loop{};
}

}

CollapsedCell CollapseSolid(int cellType, const vtkIdType* ids)
{
  CollapsedCell cell;
  const Loops sides = FindSides(*GetFaceTable(cellType), ids);
  if (!AreClosed(sides))
  {
    cell.Type = VTK_EMPTY_CELL;
    return cell;
  }
  const auto quads =
    std::count_if(sides.begin(), sides.end(), [](const Loop& side) { return side.size() == 4; });
  const auto base = std::find_if(sides.begin(), sides.end(),
    [quads](const Loop& side) { return side.size() == (quads == 1 ? 4u : 3u); });
  if ((sides.size() == 4 && quads == 0) || (sides.size() == 5 && quads == 1))
  {
    cell.Type = quads == 0 ? VTK_TETRA : VTK_PYRAMID;
    cell.Points = FindCone(sides, *base);
  }
  else if (sides.size() == 5 && quads == 3)
  {
    cell.Type = VTK_WEDGE;
    cell.Points = FindWedge(sides, *base);
  }
  if (cell.Points.empty())
  {
    cell.Type = FaceLoops;
    for (const Loop& side : sides)
    {
      cell.Points.insert(cell.Points.end(), side.begin(), side.end());
      cell.Points.push_back(side[0]);
    }
  }
  return cell;
}

}
