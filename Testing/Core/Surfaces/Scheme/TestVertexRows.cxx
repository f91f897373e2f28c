// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 5 and 12: rows that several schemes share, by the functions that append them.
#include "SchemeTools.h"

#include "Core/Surfaces/Scheme/CurveRows.h"
#include "Core/Surfaces/Scheme/CurveTangents.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/SectorRows.h"

using namespace surfacetools;

namespace
{

SurfaceLevel<int> MakeTagged(
  const Model& model, const SurfaceFeatures& features = SurfaceFeatures())
{
  SurfaceLevel<int> level = MakeLevel(model.Points.size(), model.Faces, model.Lines);
  ClassifyModel(model, *MakeSurfaceScheme<int>(SurfaceSchemeKind::Loop, true), features, level);
  return level;
}

/// The corner of a vertex in a face.
int FindCorner(const SurfaceLevel<int>& level, int face, int vertex)
{
  int corner = level.Mesh.GetFirst(face);
  while (level.Mesh.Vertices[corner] != vertex)
  {
    ++corner;
  }
  return corner;
}

int FindEdge(const SurfaceLevel<int>& level, int a, int b)
{
  int edge = 0;
  while (level.Mesh.EdgeVertices[2 * edge] + level.Mesh.EdgeVertices[2 * edge + 1] != a + b ||
    (level.Mesh.EdgeVertices[2 * edge] != a && level.Mesh.EdgeVertices[2 * edge] != b))
  {
    ++edge;
  }
  return edge;
}

// ---------------------------------------------------------------- curves

Weights GetCurveRow(const SurfaceLevel<int>& level, int vertex, double own)
{
  std::vector<int> edges{ 0, 1 }; // of before
  RowBlock<int> rows;
  AppendCurveVertex(level.Mesh, level.Tags, vertex, own, edges, rows);
  return ToWeights(rows);
}

// ---------------------------------------------------------------- cycles

/// Rows [begin, end) as maps. Those of vertices with six triangles come from `regular`, the others
/// name the vertex and how many steps the walk around it has.
std::vector<Weights> GetCycleRows(const SurfaceLevel<int>& level, int begin, int end)
{
  static constexpr std::array<double, 7> weights{ 0.4, 0.1, 0.2, 0.3, 0.5, 0.6, 0.7 };
  RowBlock<int> rows;
  AppendCycleRows(
    level.Mesh, weights, begin, end,
    [&](vtkIdType v) { return level.Tags.Vertices[v] == VertexTag::Smooth; },
    [&](int vertex, const std::vector<FanStep<int>>& steps, int* columns)
    {
      columns[0] = vertex;
      for (std::size_t k = 0; k < 6 && steps.size() == 6; ++k)
      {
        columns[k + 1] = GetNeighbour(level.Mesh, steps[k]);
      }
      return steps.size() == 6;
    },
    [&](int vertex, const std::vector<FanStep<int>>& steps)
    { rows.Add(vertex, 100. + static_cast<double>(steps.size())); }, rows);
  std::vector<Weights> maps;
  for (std::size_t row = 0; row < rows.GetNumberOfRows(); ++row)
  {
    maps.emplace_back();
    for (std::size_t i = rows.GetBegin(row); i < rows.GetEnd(row); ++i)
    {
      maps.back()[rows.GetColumns()[i]] += rows.GetWeights()[i];
    }
  }
  return maps;
}

// ---------------------------------------------------------------- sectors

/// k triangles around vertex 0 on the boundary, a corner with an angle and a flatness.
SurfaceLevel<int> MakeCorner(int k, double angle, double flatness)
{
  Model model = MakeFan(k, true);
  model.Corners = { 0 };
  SurfaceFeatures features;
  features.Angles.assign(model.Points.size(), -1.);
  features.Flatness.assign(model.Points.size(), -1.);
  features.Angles[0] = angle;
  features.Flatness[0] = flatness;
  return MakeTagged(model, features);
}

void ExpectNone(const FlatPoint<int>& flat, const std::string& what)
{
  EXPECT_EQ(flat.Flatness, 0.) << what;
  EXPECT_EQ(flat.Corner, 0) << what;
  EXPECT_EQ(flat.Ends[0] + flat.Ends[1], 0) << what;
  EXPECT_EQ(flat.Ends[0], 0) << what;
  EXPECT_EQ(flat.Weights[0], 0.) << what;
  EXPECT_EQ(flat.Weights[1], 0.) << what;
}

// ---------------------------------------------------------------- tangents

/// Where a tangent across a curve stands in a row.
constexpr int Across = 1000;

struct Tangent
{
  Weights Row;
  std::vector<int> Ring;
};

Tangent GetTangent(const SurfaceLevel<int>& level, int vertex, LimitKind kind)
{
  Tangent made{ {}, { 7, 7, 7 } };
  RowBlock<int> rows;
  AppendSectorTangent(level, level.Tags, vertex, kind, made.Ring, rows,
    [&](const SectorEnds<int>& ends, double turn) { rows.Add(Across + ends.Size, turn); });
  made.Row = ToWeights(rows);
  return made;
}

/// Two triangles in front of vertex 0, and two behind it that are turned over.
Model MakeHalfTurned()
{
  Model model = MakeFan(4, false);
  for (std::size_t face : { 2u, 3u })
  {
    std::reverse(model.Faces[face].begin(), model.Faces[face].end());
  }
  return model;
}

}

TEST(VertexRows, OnACurve)
{
  const SurfaceLevel<int> open = MakeTagged(MakeFan(4, true));
  ExpectRow(GetCurveRow(open, 0, 0.7), { { 0, 0.7 }, { 1, 0.15 }, { 5, 0.15 } }, "boundary");
  Model creased = MakeFan(6, false);
  creased.Lines = { { 0, 2 }, { 4, 0 } };
  ExpectRow(GetCurveRow(MakeTagged(creased), 0, 0.75), { { 0, 0.75 }, { 2, 0.125 }, { 4, 0.125 } },
    "crease");
}

TEST(VertexRows, OfACornerOrWithoutACurve)
{
  Model model = MakeFan(4, true);
  model.Corners = { 0 };
  ExpectRow(GetCurveRow(MakeTagged(model), 0, 0.7), { { 0, 1. } }, "corner");
  SurfaceLevel<int> closed = MakeTagged(MakeFan(5, false));
  closed.Tags.Vertices[0] = VertexTag::Curve; // as at a joint that does not move along one
  ExpectRow(GetCurveRow(closed, 0, 0.7), { { 0, 1. } }, "no edges");
  for (int end : { 1, 2, 3 })
  {
    closed.Tags.Edges[FindEdge(closed, 0, end)] = EdgeTag::Sharp;
    const Weights two{ { 0, 0.7 }, { 1, 0.15 }, { 2, 0.15 } };
    ExpectRow(GetCurveRow(closed, 0, 0.7), end == 2 ? two : Weights{ { 0, 1. } }, "some edges");
  }
}

TEST(VertexRows, NeighboursOfWalks)
{
  const SurfaceLevel<int> level = MakeTagged(MakeFan(4, true));
  const int corner = FindCorner(level, 2, 0);
  EXPECT_EQ(GetNeighbour(level.Mesh, FanStep<int>{ corner, true }), 3);
  EXPECT_EQ(GetNeighbour(level.Mesh, FanStep<int>{ corner, false }), 4);
}

TEST(VertexRows, OfManyVerticesOneAfterTheOther)
{
  for (const bool areTurned : { false, true })
  {
    SCOPED_TRACE(areTurned);
    Model model = MakeSheet(6, 5, true, { 1., 0., 0. }, { 0., 1., 0. });
    for (std::size_t face = 0; face < model.Faces.size() && areTurned; face += 3)
    {
      std::reverse(model.Faces[face].begin(), model.Faces[face].end());
    }
    const SurfaceLevel<int> level = MakeTagged(model);
    const int size = static_cast<int>(level.Mesh.NumberOfVertices);
    for (const auto& [begin, end] : { std::pair<int, int>{ 0, size }, { 3, 33 }, { 8, 16 },
           { 8, 17 }, { 9, 10 }, { 12, 12 }, { 13, 12 } })
    {
      const std::vector<Weights> rows = GetCycleRows(level, begin, end);
      ASSERT_EQ(static_cast<int>(rows.size()), std::max(0, end - begin));
      for (int v = begin; v < end; ++v)
      {
        Weights expected;
        if (level.Tags.Vertices[v] == VertexTag::Smooth)
        {
          expected[v] = 0.4;
          double weight[6] = { 0.1, 0.2, 0.3, 0.5, 0.6, 0.7 };
          int k = 0;
          VisitCycle(level.Mesh, level.Mesh.VertexCorners[v], [&](const FanStep<int>& step)
            { expected[GetNeighbour(level.Mesh, step)] = weight[k++]; });
          ASSERT_EQ(k, 6);
        }
        else
        {
          expected[v] = 100.; // no walk
        }
        ExpectRow(rows[v - begin], expected, "vertex " + std::to_string(v));
      }
    }
  }
  // One that is smooth but not regular is left to the other function, with its walk.
  const SurfaceLevel<int> fan = MakeTagged(MakeFan(5, false));
  ExpectRow(GetCycleRows(fan, 0, 1).at(0), { { 0, 105. } }, "five");
}

// Three triangles that take 270 degrees, t = 90 degrees: the point of edge j has the coordinates
// cos(jt) and sin(jt), that of a face the sum of those of its edges, and s = 3/10 is given.
TEST(VertexRows, TowardsThePlaneOfACorner)
{
  const SurfaceLevel<int> level = MakeCorner(3, 1.5 * Pi, 0.3);
  const auto findOfEdge = [&](int edge, int face)
  {
    return FindFlatPoint(
      level.Mesh, level.Tags, 0, FindCorner(level, face, 0), FindEdge(level, 0, 1 + edge), false);
  };
  const auto findOfFace = [&](int face)
  { return FindFlatPoint(level.Mesh, level.Tags, 0, FindCorner(level, face, 0), -1, true); };
  // The sector begins at one of the two ends of the boundary.
  const int first = findOfEdge(1, 1).Ends[0];
  const bool turned = first == 4;
  ASSERT_TRUE(turned || first == 1);
  const auto check = [&](const FlatPoint<int>& flat, double c, double s, const std::string& what)
  {
    EXPECT_EQ(flat.Flatness, 0.3) << what;
    EXPECT_EQ(flat.Corner, 0) << what;
    EXPECT_EQ(flat.Ends[turned ? 1 : 0], 1) << what;
    EXPECT_EQ(flat.Ends[turned ? 0 : 1], 4) << what;
    // In the plane: c e0 + s e1, where the last edge is at -e1.
    EXPECT_NEAR(flat.Weights[turned ? 1 : 0], c / 2., 1e-15) << what;
    EXPECT_NEAR(flat.Weights[turned ? 0 : 1], -s / 2., 1e-15) << what;
    RowBlock<int> rows;
    flat.Append(rows, 0.4);
    ExpectRow(ToWeights(rows),
      { { 0, 0.4 * (1. - c / 2. + s / 2.) }, { 1, 0.2 * c }, { 4, -0.2 * s } }, what);
  };
  for (int face : { 0, 1, 2 }) // the corner may be in any face of the sector
  {
    check(findOfEdge(1, face), 0., 1., "edge 1");
    check(findOfEdge(2, face), -1., 0., "edge 2");
  }
  check(findOfFace(0), 1., 1., "face 0");
  check(findOfFace(1), -1., 1., "face 1");
  check(findOfFace(2), -1., -1., "face 2");
}

TEST(VertexRows, NoPlaneWithoutACornerOrFlatness)
{
  const SurfaceLevel<int> level = MakeCorner(3, 1.5 * Pi, 0.3);
  const int corner = FindCorner(level, 1, 0);
  const int edge = FindEdge(level, 0, 2);
  ASSERT_EQ(FindFlatPoint(level.Mesh, level.Tags, 0, corner, edge, false).Flatness, 0.3);
  SurfaceLevel<int> other = MakeCorner(3, 1.5 * Pi, 0.3);
  other.Tags.Vertices[0] = VertexTag::Curve;
  ExpectNone(FindFlatPoint(other.Mesh, other.Tags, 0, corner, edge, false), "a curve");
  other = MakeCorner(3, 1.5 * Pi, 0.3);
  other.Tags.Sectors.clear();
  ExpectNone(FindFlatPoint(other.Mesh, other.Tags, 0, corner, edge, false), "no sectors");
  other = MakeCorner(3, 1.5 * Pi, 0.);
  ExpectNone(FindFlatPoint(other.Mesh, other.Tags, 0, corner, edge, false), "no flatness");
  other = MakeCorner(3, 1.5 * Pi, 0.3);
  other.Tags.Sectors[0].Vertex = 1;
  ExpectNone(FindFlatPoint(other.Mesh, other.Tags, 0, corner, edge, false), "of another vertex");
  // At the end of a crease no edge ends a sector.
  Model model = MakeFan(5, false);
  model.Lines = { { 0, 1 } };
  other = MakeTagged(model);
  ASSERT_EQ(other.Tags.Vertices[0], VertexTag::Corner);
  other.Tags.Sectors.push_back({ 0, 0, 0, 5, 1.5 * Pi, 0.3 });
  for (int face = 0; face < 5; ++face)
  {
    ExpectNone(FindFlatPoint(other.Mesh, other.Tags, 0, FindCorner(other, face, 0),
                 FindEdge(other, 0, 3), false),
      "end of a crease");
  }
  other.Tags.Sectors.clear();
  for (int face = 0; face < 5; ++face) // not even if one is given
  {
    const int at = FindCorner(other, face, 0);
    other.Tags.Sectors.push_back({ 0, at, at, 5, 1.5 * Pi, 0.3 });
  }
  for (int face = 0; face < 5; ++face)
  {
    ExpectNone(
      FindFlatPoint(other.Mesh, other.Tags, 0, FindCorner(other, face, 0), -1, true), "a face");
  }
}

TEST(VertexRows, APlaneOfOneFace)
{
  Model model = MakeFan(1, true);
  model.Faces[0] = { 1, 2, 0 };
  model.Corners = { 2 };
  SurfaceFeatures features;
  features.Angles = { -1., -1., Pi / 2. };
  features.Flatness = { -1., -1., 0.3 };
  const SurfaceLevel<int> level = MakeTagged(model, features);
  const FlatPoint<int> flat =
    FindFlatPoint(level.Mesh, level.Tags, 2, FindCorner(level, 0, 2), -1, true);
  EXPECT_EQ(flat.Flatness, 0.3);
  EXPECT_EQ(flat.Corner, 2);
  EXPECT_EQ(std::minmax(flat.Ends[0], flat.Ends[1]), std::minmax(0, 1));
  EXPECT_NEAR(flat.Weights[0], 0.5, 1e-15);
  EXPECT_NEAR(flat.Weights[1], 0.5, 1e-15);
}

// Two and four triangles between two creases. The other end of the walk is the last crease itself.
TEST(VertexRows, APlaneForEachSectorOfACorner)
{
  Model model = MakeFan(6, false);
  model.Lines = { { 0, 1 }, { 0, 3 } };
  model.Corners = { 0 };
  SurfaceLevel<int> level = MakeTagged(model);
  for (Sector<int>& sector : level.Tags.Sectors)
  {
    sector.Flatness = sector.Size == 2 ? 0.2 : 0.4;
    sector.Angle = Pi / 2.;
  }
  const auto find = [&](int edge, int face, bool isFace)
  {
    return FindFlatPoint(
      level.Mesh, level.Tags, 0, FindCorner(level, face, 0), FindEdge(level, 0, edge), isFace);
  };
  EXPECT_EQ(find(2, 0, false).Flatness, 0.2);
  EXPECT_EQ(find(5, 3, false).Flatness, 0.4);
  ExpectNone(find(5, 0, false), "an edge of the other sector");
  ExpectNone(find(2, 3, false), "an edge of the other sector");
  for (int face = 0; face < 6; ++face)
  {
    // Of 45 or 22.5 degrees from the middle of the face to the edges.
    const FlatPoint<int> flat = find(2, face, true);
    const int size = face < 2 ? 2 : 4;
    EXPECT_EQ(flat.Flatness, size == 2 ? 0.2 : 0.4);
    const double t = Pi / 2. / size;
    const int j = face < 2 ? face : face - 2;
    const bool turned = flat.Ends[0] != (size == 2 ? 1 : 3);
    EXPECT_EQ(flat.Ends[0] + flat.Ends[1], 4);
    EXPECT_NEAR(
      flat.Weights[turned ? 1 : 0], (std::cos(j * t) + std::cos((j + 1) * t)) / 2., 1e-15);
    EXPECT_NEAR(
      flat.Weights[turned ? 0 : 1], (std::sin(j * t) + std::sin((j + 1) * t)) / 2., 1e-15);
  }
  for (const int edge : { 1, 3 }) // half of the way along the sharp edges
  {
    const FlatPoint<int> flat = find(edge, 0, false);
    EXPECT_EQ(flat.Flatness, 0.2) << edge;
    for (int end = 0; end < 2; ++end)
    {
      EXPECT_NEAR(flat.Weights[end], flat.Ends[end] == edge ? 0.5 : 0., 1e-15) << edge;
    }
  }
}

TEST(VertexRows, TangentsOnACurve)
{
  for (const bool isReversed : { false, true })
  {
    SCOPED_TRACE(isReversed);
    Model model = MakeFan(4, true);
    for (auto& face : model.Faces)
    {
      if (isReversed)
      {
        std::reverse(face.begin(), face.end());
      }
    }
    const SurfaceLevel<int> level = MakeTagged(model);
    const Tangent along = GetTangent(level, 0, LimitKind::Tangent1);
    ASSERT_EQ(along.Ring.size(), 5u);
    const int first = along.Ring.front();
    const int last = along.Ring.back();
    EXPECT_EQ(first + last, 6);
    for (int i = 0; i < 5; ++i)
    {
      EXPECT_EQ(along.Ring[static_cast<std::size_t>(i)], first == 1 ? 1 + i : 5 - i);
    }
    ExpectRow(along.Row, { { first, 1. }, { last, -1. } }, "along");
    const SectorEnds<int> ends =
      FindSectorEnds(level.Mesh, level.Tags, FindTangentCorner(level.Mesh, level.Tags, 0));
    ExpectRow(GetTangent(level, 0, LimitKind::Tangent2).Row,
      { { Across + 4, ends.First.Forward ? 1. : -1. } }, "across");
  }
}

// Which way the walk goes through its first face turns the tangent across.
TEST(VertexRows, TangentsTurnWithTheFirstFace)
{
  Model model = MakeHalfTurned();
  model.Lines = { { 0, 2 }, { 0, 4 } };
  std::set<double> turns;
  for (int face = 0; face < 4; ++face)
  {
    SurfaceLevel<int> level = MakeTagged(model);
    level.Mesh.VertexCorners[0] = FindCorner(level, face, 0);
    const SectorEnds<int> ends =
      FindSectorEnds(level.Mesh, level.Tags, FindTangentCorner(level.Mesh, level.Tags, 0));
    ASSERT_EQ(ends.Size, 2);
    const Tangent across = GetTangent(level, 0, LimitKind::Tangent2);
    ExpectRow(across.Row, { { Across + 2, ends.First.Forward ? 1. : -1. } }, "across");
    turns.insert(across.Row.begin()->second);
    const Tangent along = GetTangent(level, 0, LimitKind::Tangent1);
    ASSERT_EQ(along.Ring.size(), 3u);
    ExpectRow(along.Row, { { along.Ring.front(), 1. }, { along.Ring.back(), -1. } }, "along");
    EXPECT_EQ(along.Ring.front() + along.Ring.back(), 6);
  }
  EXPECT_EQ(turns, (std::set<double>{ -1., 1. }));
}

// At a corner the first tangent is the first edge r, the second one is in the plane of r and q and
// perpendicular to r: (q - r cos) / sin.
TEST(VertexRows, TangentsAtACorner)
{
  for (const double angle : { Pi / 2., 2., 4. })
  {
    for (const bool hasSector : { true, false })
    {
      SurfaceLevel<int> level = MakeCorner(4, angle, 0.);
      const double used = hasSector ? angle : Pi / 2.;
      if (!hasSector)
      {
        level.Tags.Sectors.clear();
      }
      const Tangent along = GetTangent(level, 0, LimitKind::Tangent1);
      const int first = along.Ring.front();
      const int last = along.Ring.back();
      ASSERT_EQ(first + last, 6);
      ExpectRow(along.Row, { { first, 1. }, { 0, -1. } }, "along");
      const SectorEnds<int> ends =
        FindSectorEnds(level.Mesh, level.Tags, FindTangentCorner(level.Mesh, level.Tags, 0));
      const double turn = ends.First.Forward ? 1. : -1.;
      const double r = -turn / std::tan(used);
      const double q = turn / std::sin(used);
      ExpectRow(GetTangent(level, 0, LimitKind::Tangent2).Row,
        { { first, r }, { last, q }, { 0, -r - q } }, "perpendicular");
    }
  }
}

// Where no sector is, lines have a tangent along them, and nothing has one across.
TEST(VertexRows, TangentsWithoutASector)
{
  Model model = MakeFan(3, true);
  model.Points.resize(9);
  model.Lines = { { 5, 6 }, { 6, 7 } };
  const SurfaceLevel<int> lines = MakeTagged(model);
  const Tangent along = GetTangent(lines, 6, LimitKind::Tangent1);
  ASSERT_EQ(along.Ring.size(), 2u);
  ExpectRow(along.Row,
    { { lines.Mesh.GetOtherEnd(along.Ring[0], 6), 1. },
      { lines.Mesh.GetOtherEnd(along.Ring[1], 6), -1. } },
    "along lines");
  EXPECT_EQ(along.Row.count(5) + along.Row.count(7), 2u);
  EXPECT_TRUE(GetTangent(lines, 6, LimitKind::Tangent2).Row.empty());
  EXPECT_TRUE(GetTangent(lines, 5, LimitKind::Tangent1).Row.empty());
  // The end of a crease, and a corner of two lines: no curve goes through these.
  Model crease = MakeFan(5, false);
  crease.Lines = { { 0, 1 } };
  EXPECT_TRUE(GetTangent(MakeTagged(crease), 0, LimitKind::Tangent1).Row.empty());
  model.Corners = { 6 };
  EXPECT_TRUE(GetTangent(MakeTagged(model), 6, LimitKind::Tangent1).Row.empty());
}
