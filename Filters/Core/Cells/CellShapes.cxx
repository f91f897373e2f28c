// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Cells/CellShapes.h"

#include <algorithm>

namespace subdivision
{
namespace
{

using Corners = std::vector<unsigned char>;

bool Includes(const Corners& all, const Corners& some)
{
  return std::all_of(some.begin(), some.end(),
    [&all](unsigned char c) { return std::find(all.begin(), all.end(), c) != all.end(); });
}

/// The smallest part of a cell that has these corners.
CellPart FindPart(const CellTable& table, const Corners& corners)
{
  if (corners.size() == 1)
  {
    return { CellPart::AtCorner, corners[0] };
  }
  for (std::size_t e = 0; e < table.Edges.size(); ++e)
  {
    if (Includes({ table.Edges[e][0], table.Edges[e][1] }, corners))
    {
      return { CellPart::InEdge, static_cast<unsigned char>(e) };
    }
  }
  for (std::size_t f = 0; f < table.Faces.size(); ++f)
  {
    if (Includes(table.Faces[f], corners))
    {
      return { CellPart::InFace, static_cast<unsigned char>(f) };
    }
  }
  return {};
}

/// Lists edges of faces, quads, and local points.
void Complete(CellTable& table)
{
  for (std::size_t f = 0; f < table.Faces.size(); ++f)
  {
    const Corners& face = table.Faces[f];
    Corners edges;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      edges.push_back(FindPart(table, { face[i], face[(i + 1) % face.size()] }).Index);
    }
    table.FaceEdges.push_back(edges);
    if (face.size() == 4)
    {
      table.Quads.push_back(static_cast<unsigned char>(f));
    }
  }
  for (int i = 0; i < table.Corners; ++i)
  {
    table.PointCorners.push_back({ static_cast<unsigned char>(i) });
  }
  for (const auto& edge : table.Edges)
  {
    table.PointCorners.push_back({ edge[0], edge[1] });
  }
  for (const unsigned char quad : table.Quads)
  {
    table.PointCorners.push_back(table.Faces[quad]);
  }
  if (table.HasCentre)
  {
    table.PointCorners.emplace_back();
    for (int i = 0; i < table.Corners; ++i)
    {
      table.PointCorners.back().push_back(static_cast<unsigned char>(i));
    }
  }
  for (const Corners& corners : table.PointCorners)
  {
    table.Points.push_back(FindPart(table, corners));
  }
}

void AddChild(CellTable& table, CellShape shape, const std::vector<int>& points)
{
  CellChild child{ shape, {}, {}, {} };
  std::copy(points.begin(), points.end(), child.Points.begin());
  table.Children.push_back(child);
}

/// The child at corner i has at place j the middle of the smallest edge, quad or cell that has the
/// corners i and j.
void AddChildAtCorner(CellTable& table, CellShape shape, int i)
{
  std::vector<int> points;
  for (int j = 0; j < table.Corners; ++j)
  {
    const Corners both = i == j
      ? Corners{ static_cast<unsigned char>(i) }
      : Corners{ static_cast<unsigned char>(i), static_cast<unsigned char>(j) };
    std::size_t p = 0;
    while (!Includes(table.PointCorners[p], both))
    {
      ++p;
    }
    points.push_back(static_cast<int>(p));
  }
  AddChild(table, shape, points);
}

CellTable MakeTable(CellShape shape, int dimension, int corners,
  std::vector<std::array<unsigned char, 2>> edges, std::vector<Corners> faces,
  bool hasCentre = false)
{
  CellTable table;
  table.Dimension = dimension;
  table.Corners = corners;
  table.Edges = std::move(edges);
  table.Faces = std::move(faces);
  table.HasCentre = hasCentre;
  Complete(table);
  // A wedge has an inner child between these, and a pyramid no child at its apex.
  const int ofCorners = shape == CellShape::Pyramid ? 4 : shape == CellShape::Wedge ? 3 : corners;
  for (int i = 0; i < ofCorners; ++i)
  {
    AddChildAtCorner(table, shape, i);
  }
  return table;
}

CellTable MakeTet()
{
  CellTable tet =
    MakeTable(CellShape::Tet, 3, 4, { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } },
      { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } });
  AddChild(tet, CellShape::Octahedron, { 4, 9, 6, 7, 5, 8 });
  return tet;
}

CellTable MakePyramid()
{
  CellTable pyramid = MakeTable(CellShape::Pyramid, 3, 5,
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } },
    { { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } });
  AddChild(pyramid, CellShape::Octahedron, { 4, 13, 9, 11, 10, 12 });
  for (const auto& tet :
    { std::vector<int>{ 5, 13, 9, 10 }, { 6, 13, 10, 11 }, { 7, 13, 11, 12 }, { 8, 13, 12, 9 } })
  {
    AddChild(pyramid, CellShape::Tet, tet);
  }
  return pyramid;
}

CellTable MakeWedge()
{
  CellTable wedge = MakeTable(CellShape::Wedge, 3, 6,
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } },
    { { 0, 1, 2 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } });
  AddChild(wedge, CellShape::Wedge, { 6, 7, 8, 15, 16, 17 });
  for (int i = 3; i < 6; ++i)
  {
    AddChildAtCorner(wedge, CellShape::Wedge, i);
  }
  AddChild(wedge, CellShape::Wedge, { 15, 16, 17, 9, 10, 11 });
  return wedge;
}

/// Corners 2k and 2k + 1 are opposite.
CellTable MakeOctahedron()
{
  std::vector<Corners> faces;
  for (int f = 0; f < 8; ++f)
  {
    faces.push_back({ static_cast<unsigned char>(f & 1),
      static_cast<unsigned char>(2 + (f >> 1 & 1)), static_cast<unsigned char>(4 + (f >> 2)) });
  }
  CellTable oct = MakeTable(CellShape::Octahedron, 3, 6,
    { { 0, 2 }, { 0, 3 }, { 0, 4 }, { 0, 5 }, { 1, 2 }, { 1, 3 }, { 1, 4 }, { 1, 5 }, { 2, 4 },
      { 2, 5 }, { 3, 4 }, { 3, 5 } },
    faces, true);
  constexpr int centre = 18;
  const auto middle = [&oct](int p, int q)
  {
    const auto part =
      FindPart(oct, { static_cast<unsigned char>(p), static_cast<unsigned char>(q) });
    return 6 + part.Index;
  };
  for (const int p : { 0, 1 })
  {
    for (const int q : { 2, 3 })
    {
      for (const int r : { 4, 5 })
      {
        const bool isOdd = (p + q + r) % 2 == 1;
        AddChild(oct, CellShape::Tet,
          { centre, middle(p, q), isOdd ? middle(r, p) : middle(q, r),
            isOdd ? middle(q, r) : middle(r, p) });
      }
    }
  }
  return oct;
}

using CellTables = std::array<CellTable, NumberOfShapes>;

/// Finds the parts in which edges and faces of children lie.
void LocateChildren(CellTables& tables)
{
  const auto locate = [](const CellTable& table, const CellChild& child, const auto& corners)
  {
    Corners all;
    for (const int c : corners)
    {
      const Corners& more = table.PointCorners[child.Points[c]];
      all.insert(all.end(), more.begin(), more.end());
    }
    return FindPart(table, all);
  };
  for (CellTable& table : tables)
  {
    for (CellChild& child : table.Children)
    {
      const CellTable& shape = tables[static_cast<std::size_t>(child.Shape)];
      for (const auto& edge : shape.Edges)
      {
        child.Edges.push_back(locate(table, child, edge));
      }
      for (const auto& face : shape.Faces)
      {
        child.Faces.push_back(locate(table, child, face));
      }
    }
  }
}

CellTables MakeTables()
{
  CellTables tables{ MakeTable(CellShape::Vertex, 0, 1, {}, {}),
    MakeTable(CellShape::Line, 1, 2, { { 0, 1 } }, {}),
    MakeTable(CellShape::Triangle, 2, 3, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, { { 0, 1, 2 } }),
    MakeTable(
      CellShape::Quad, 2, 4, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } }, { { 0, 1, 2, 3 } }),
    MakeTet(), MakePyramid(), MakeWedge(),
    MakeTable(CellShape::Hex, 3, 8,
      { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 },
        { 1, 5 }, { 2, 6 }, { 3, 7 } },
      { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
        { 3, 0, 4, 7 } },
      true),
    MakeOctahedron() };
  AddChild(tables[static_cast<std::size_t>(CellShape::Triangle)], CellShape::Triangle, { 3, 4, 5 });
  LocateChildren(tables);
  return tables;
}

}

const CellTable& GetCellTable(CellShape shape)
{
  static const CellTables tables = MakeTables();
  return tables[static_cast<std::size_t>(shape)];
}

std::array<double, NumberOfShapes> CountChildren(const std::array<double, NumberOfShapes>& cells)
{
  std::array<double, NumberOfShapes> counts{};
  for (int s = 0; s < NumberOfShapes; ++s)
  {
    for (const CellChild& child : GetCellTable(static_cast<CellShape>(s)).Children)
    {
      counts[static_cast<std::size_t>(child.Shape)] += cells[s];
    }
  }
  return counts;
}

}
