// SPDX-License-Identifier: BSD-3-Clause
#include "HybridReferenceCells.h"

#include <algorithm>
#include <map>

namespace hybridtest
{

namespace
{

Table MakeOctahedron()
{
  Table table = { 3,
    { { 0, 2 }, { 0, 3 }, { 0, 4 }, { 0, 5 }, { 1, 2 }, { 1, 3 }, { 1, 4 }, { 1, 5 }, { 2, 4 },
      { 2, 5 }, { 3, 4 }, { 3, 5 } },
    {}, {}, true, {} };
  const auto middle = [&table](int i, int j)
  {
    const auto found = std::find(table.Edges.begin(), table.Edges.end(), Ids{ i, j });
    return 6 + static_cast<int>(found - table.Edges.begin());
  };
  for (int p = 0; p < 2; ++p)
  {
    for (int q = 2; q < 4; ++q)
    {
      for (int r = 4; r < 6; ++r)
      {
        table.Triangles.push_back({ p, q, r });
        Ids tet = { 18, middle(p, q), middle(q, r), middle(p, r) };
        if ((p + q + r) % 2 == 1)
        {
          std::swap(tet[2], tet[3]);
        }
        table.Inner.emplace_back(Type::Tet, tet);
      }
    }
  }
  return table;
}

}

const Table& GetTable(Type shape)
{
  static const std::map<Type, Table> tables = { { Type::Vertex, { 0, {}, {}, {}, false, {} } },
    { Type::Line, { 1, { { 0, 1 } }, {}, {}, false, {} } },
    { Type::Triangle,
      { 2, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, {}, { { 0, 1, 2 } }, false,
        { { Type::Triangle, { 3, 4, 5 } } } } },
    { Type::Quad,
      { 2, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } }, { { 0, 1, 2, 3 } }, {}, false, {} } },
    { Type::Tet,
      { 3, { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }, {},
        { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 2, 3 } }, false,
        { { Type::Octahedron, { 4, 9, 6, 7, 5, 8 } } } } },
    { Type::Pyramid,
      { 3, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } },
        { { 0, 1, 2, 3 } }, { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } }, false,
        { { Type::Octahedron, { 4, 13, 9, 11, 10, 12 } }, { Type::Tet, { 5, 13, 9, 10 } },
          { Type::Tet, { 6, 13, 10, 11 } }, { Type::Tet, { 7, 13, 11, 12 } },
          { Type::Tet, { 8, 13, 12, 9 } } } } },
    { Type::Wedge,
      { 3,
        { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 },
          { 2, 5 } },
        { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } }, { { 0, 1, 2 }, { 3, 4, 5 } }, false,
        { { Type::Wedge, { 6, 7, 8, 15, 16, 17 } },
          { Type::Wedge, { 15, 16, 17, 9, 10, 11 } } } } },
    { Type::Hex,
      { 3,
        { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 },
          { 1, 5 }, { 2, 6 }, { 3, 7 } },
        { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
          { 3, 0, 4, 7 } },
        {}, true, {} } },
    { Type::Octahedron, MakeOctahedron() } };
  return tables.at(shape);
}

bool Has(const Ids& ids, int id)
{
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

Ids Named(const Cell& cell, const Ids& locals)
{
  Ids ids;
  for (int i : locals)
  {
    ids.push_back(cell.Corners[i]);
  }
  return ids;
}

bool HasSide(const Cell& cell, const Ids& side, int dimension)
{
  const std::vector<Cell> sides = Sides(cell, dimension);
  return std::any_of(
    sides.begin(), sides.end(), [&side](const Cell& own) { return Sorted(own.Corners) == side; });
}

int DimensionOf(Type shape)
{
  return GetTable(shape).Dimension;
}

Ids Sorted(Ids ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<Cell> Sides(const Cell& cell, int dimension)
{
  const Table& table = GetTable(cell.Shape);
  if (table.Dimension == dimension)
  {
    return { cell };
  }
  std::vector<Cell> sides;
  for (std::size_t i = 0; i < cell.Corners.size() && dimension == 0; ++i)
  {
    sides.push_back({ Type::Vertex, { cell.Corners[i] } });
  }
  const auto add = [&](Type shape, const Locals& all)
  {
    for (const Ids& locals : all)
    {
      sides.push_back({ shape, Named(cell, locals) });
    }
  };
  if (dimension == 1)
  {
    add(Type::Line, table.Edges);
  }
  if (dimension == 2)
  {
    add(Type::Quad, table.Quads);
    add(Type::Triangle, table.Triangles);
  }
  return sides;
}

double Centroid(const Cell& cell, std::size_t i, std::vector<double>& shares)
{
  const std::size_t size = cell.Corners.size();
  shares.assign(size, 1. / static_cast<double>(size));
  switch (cell.Shape)
  {
    case Type::Triangle:
      shares.assign(size, 3. / 8);
      shares[i] = 1. / 4;
      return 2.;
    case Type::Quad:
      return 3.;
    case Type::Tet:
      shares.assign(size, 17. / 48);
      shares[i] = -1. / 16;
      return 1.;
    case Type::Octahedron:
      shares.assign(size, 1. / 12);
      shares[i] = 3. / 8;
      shares[i ^ 1U] = 7. / 24;
      return 1.;
    case Type::Pyramid:
      shares.assign(size, i == 4 ? 11. / 48 : 1. / 16);
      shares[4] = i == 4 ? 1. / 12 : 1. / 4;
      if (i < 4)
      {
        shares[i] = 17. / 48;
        shares[(i + 2) % 4] = 13. / 48;
      }
      return i == 4 ? 1. : 1. / 2;
    case Type::Wedge:
      shares.assign(size, 3. / 16);
      shares[i] = shares[(i + 3) % 6] = 1. / 8;
      return 7. / 6;
    case Type::Hex:
      return 7. / 4;
    default:
      return 1.;
  }
}

}
