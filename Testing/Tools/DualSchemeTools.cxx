// SPDX-License-Identifier: BSD-3-Clause
#include "DualSchemeTools.h"

#include <algorithm>
#include <random>

namespace dualtools
{

Level MakeLevel(int vertices, const Faces& faces, const std::vector<int>& segments)
{
  subdivision::PolygonList<int> list;
  list.NumberOfVertices = vertices;
  list.FaceOffsets = subdivision::Buffer<int>(static_cast<vtkIdType>(faces.size()) + 1);
  std::vector<int> corners;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    list.FaceOffsets[f] = static_cast<int>(corners.size());
    corners.insert(corners.end(), faces[f].begin(), faces[f].end());
  }
  list.FaceOffsets[faces.size()] = static_cast<int>(corners.size());
  list.Vertices = subdivision::Buffer<int>(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), list.Vertices.begin());
  list.Segments = subdivision::Buffer<int>(static_cast<vtkIdType>(segments.size()));
  std::copy(segments.begin(), segments.end(), list.Segments.begin());
  Level level;
  level.Mesh = subdivision::BuildPolygonMesh(std::move(list), level.Lines);
  return level;
}

Faces MakeQuads(int columns, int rows)
{
  Faces faces;
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < columns; ++x)
    {
      const int a = y * (columns + 1) + x;
      faces.push_back({ a, a + 1, a + columns + 2, a + columns + 1 });
    }
  }
  return faces;
}

Faces MakeTorus(int n)
{
  Faces faces;
  auto id = [n](int x, int y) { return (y % n) * n + x % n; };
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      faces.push_back({ id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1) });
    }
  }
  return faces;
}

Faces MakeFan(int k, bool open)
{
  Faces faces;
  for (int i = 0; i < k; ++i)
  {
    faces.push_back({ 0, 1 + i, open ? 2 + i : 1 + (i + 1) % k });
  }
  return faces;
}

Faces MakeMoebius(int n)
{
  Faces faces;
  for (int i = 0; i + 1 < n; ++i)
  {
    faces.push_back({ 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 });
  }
  faces.push_back({ 2 * n - 2, 1, 0, 2 * n - 1 });
  return faces;
}

std::vector<Shape> MakeShapes()
{
  const Faces cube = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  const Faces tetrahedron = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  Faces flipped = MakeQuads(3, 3);
  for (std::size_t f = 0; f < flipped.size(); f += 2)
  {
    std::reverse(flipped[f].begin(), flipped[f].end());
  }
  return { { "triangle", 3, { { 0, 1, 2 } }, 1, true }, { "cube", 8, cube, 2, true },
    { "tetrahedron", 4, tetrahedron, 2, true },
    { "mixed", 7, { { 0, 1, 2, 3, 4 }, { 1, 0, 5 }, { 2, 1, 5, 6 } }, 1, true },
    { "grid", 20, MakeQuads(4, 3), 1, true }, { "torus", 16, MakeTorus(4), 0, true },
    { "Moebius strip", 10, MakeMoebius(5), 0, false }, { "flipped", 16, flipped, 1, false },
    { "pillow", 3, { { 0, 1, 2 }, { 0, 2, 1 } }, 2, true },
    { "three sheets", 5, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, 3, true },
    { "pinched", 5, { { 0, 1, 2 }, { 0, 3, 4 } }, 2, true },
    { "hub", 9, MakeFan(8, false), 1, true },
    { "valence 2", 4, { { 0, 1, 2 }, { 0, 2, 3 } }, 1, true },
    { "closed valence 2", 5, { { 0, 1, 3, 2 }, { 0, 2, 4, 1 } }, 1, true } };
}

Points MakePoints(int n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  Points points(n);
  for (auto& p : points)
  {
    p = { coordinate(random), coordinate(random), coordinate(random) };
  }
  return points;
}

Steps::Steps(Level&& control, subdivision::SurfaceSchemeKind kind, int steps, int firstStep)
{
  control.Step = firstStep;
  this->Values = std::make_unique<subdivision::SurfaceSteps<int>>(
    std::move(control), subdivision::MakeSurfaceScheme<int>(kind, true), steps, true, nullptr);
}

subdivision::SparseRows<int> Steps::GetRows(int step) const
{
  return this->Values->GetStep(step).Store();
}

Points Steps::Apply(int step, const Points& in) const
{
  const auto operation = this->Values->GetStep(step);
  Points out(operation.GetNumberOfRows());
  operation.Apply(in.data()->data(), out.data()->data(), 3);
  return out;
}

Points Steps::ApplyLimit(subdivision::LimitKind kind, const Points& in) const
{
  Points out(in.size());
  this->Values->GetLimit(kind).Apply(in.data()->data(), out.data()->data(), 3);
  return out;
}

std::vector<subdivision::Carrier<int>> Steps::GetCarriers(int step) const
{
  const Level& level = (*this)[step];
  subdivision::Buffer<subdivision::Carrier<int>> carriers;
  this->Values->GetScheme().CarryFaces(
    level, subdivision::MakeCarriers<int>(level.Mesh.NumberOfFaces), true, carriers);
  return { carriers.begin(), carriers.end() };
}

Faces GetFaces(const Mesh& mesh)
{
  Faces faces;
  for (int f = 0; f < mesh.NumberOfFaces; ++f)
  {
    const int* first = mesh.Vertices.data() + mesh.GetFirst(f);
    faces.emplace_back(first, first + mesh.GetSize(f));
  }
  return faces;
}

void ExpectConforming(const Level& level)
{
  const Mesh& mesh = level.Mesh;
  const Faces faces = GetFaces(mesh);
  for (const auto& face : faces)
  {
    EXPECT_GE(face.size(), 3u);
    EXPECT_EQ(std::set<int>(face.begin(), face.end()).size(), face.size());
  }
  const Level built = MakeLevel(static_cast<int>(mesh.NumberOfVertices), faces);
  EXPECT_TRUE(built.Mesh.Sheaves.empty());
  EXPECT_TRUE(built.Mesh.Joints.empty());
  ASSERT_EQ(built.Mesh.Twins.size(), mesh.Twins.size());
  EXPECT_TRUE(std::equal(mesh.Twins.begin(), mesh.Twins.end(), built.Mesh.Twins.begin()));
  ASSERT_EQ(built.Mesh.VertexCorners.size(), mesh.VertexCorners.size());
  EXPECT_TRUE(std::equal(
    mesh.VertexCorners.begin(), mesh.VertexCorners.end(), built.Mesh.VertexCorners.begin()));
  for (int c = 0; c < mesh.Vertices.size(); ++c)
  {
    EXPECT_EQ(mesh.GetFace(c), built.Mesh.GetFace(c));
  }
}

int GetEuler(const Level& level)
{
  const Mesh& mesh = level.Mesh;
  std::set<int> used(mesh.Vertices.begin(), mesh.Vertices.end());
  int sides = 0;
  for (int c = 0; c < mesh.Twins.size(); ++c)
  {
    sides += mesh.Twins[c] < c;
  }
  return static_cast<int>(used.size()) - sides + static_cast<int>(mesh.NumberOfFaces);
}

int CountOpenSides(const Level& level)
{
  int open = 0;
  for (const int twin : level.Mesh.Twins)
  {
    open += twin < 0;
  }
  return open;
}

void ExpectOriented(const Level& level)
{
  const Mesh& mesh = level.Mesh;
  for (int c = 0; c < mesh.Twins.size(); ++c)
  {
    if (mesh.Twins[c] >= 0)
    {
      EXPECT_EQ(mesh.Vertices[mesh.Twins[c]], mesh.Vertices[mesh.Next(c)]);
    }
  }
}

std::vector<Segment> GetBoundary(const Level& level, const Points& points)
{
  std::vector<Segment> segments;
  for (int c = 0; c < level.Mesh.Twins.size(); ++c)
  {
    if (level.Mesh.Twins[c] < 0)
    {
      segments.push_back(
        { points[level.Mesh.Vertices[c]], points[level.Mesh.Vertices[level.Mesh.Next(c)]] });
    }
  }
  return segments;
}

void ExpectChaikin(const std::vector<Segment>& coarse, const std::vector<Segment>& fine)
{
  ASSERT_EQ(fine.size(), 2 * coarse.size());
  auto blend = [](const Segment& s, double t)
  {
    std::array<double, 3> p{};
    for (int c = 0; c < 3; ++c)
    {
      p[c] = (1. - t) * s[0][c] + t * s[1][c];
    }
    return p;
  };
  auto has = [&](const std::array<double, 3>& a, const std::array<double, 3>& b)
  {
    return std::any_of(fine.begin(), fine.end(), [&](const Segment& s)
      { return (IsNear(s[0], a) && IsNear(s[1], b)) || (IsNear(s[0], b) && IsNear(s[1], a)); });
  };
  for (const Segment& s : coarse)
  {
    EXPECT_TRUE(has(blend(s, 0.25), blend(s, 0.75)));
    for (const Segment& next : coarse)
    {
      if (IsNear(s[1], next[0]))
      {
        EXPECT_TRUE(has(blend(s, 0.75), blend(next, 0.25)));
      }
    }
  }
}

void ExpectAverages(const subdivision::SparseRows<int>& rows)
{
  for (vtkIdType r = 0; r < rows.GetNumberOfRows(); ++r)
  {
    double sum = 0.;
    std::set<int> columns;
    for (int k = rows.Offsets[r]; k < rows.Offsets[r + 1]; ++k)
    {
      EXPECT_GE(rows.Weights[k], 0.);
      EXPECT_TRUE(columns.insert(rows.Columns[k]).second);
      sum += rows.Weights[k];
    }
    EXPECT_NEAR(sum, 1., 1e-14);
  }
}

std::array<double, 3> GetCentre(const Mesh& mesh, int face, const Points& points)
{
  std::array<double, 3> centre{};
  for (int c = mesh.GetFirst(face); c < mesh.GetFirst(face) + mesh.GetSize(face); ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      centre[i] += points[mesh.Vertices[c]][i] / mesh.GetSize(face);
    }
  }
  return centre;
}

void ExpectDualSteps(subdivision::SurfaceSchemeKind kind, int levels)
{
  for (const Shape& shape : MakeShapes())
  {
    SCOPED_TRACE(shape.Name);
    const Steps steps(MakeLevel(shape.NumberOfVertices, shape.Polygons), kind, levels);
    Points points = MakePoints(shape.NumberOfVertices);
    for (int step = 0; step < levels; ++step)
    {
      SCOPED_TRACE(step);
      const Level& next = steps[step + 1];
      ExpectAverages(steps.GetRows(step));
      ExpectConforming(next);
      EXPECT_EQ(GetEuler(next), shape.Euler);
      if (shape.Orientation)
      {
        ExpectOriented(next);
      }
      const Points moved = steps.Apply(step, points);
      // The first faces are the old ones, and keep their centres: these are limit positions.
      for (int f = 0; f < steps[step].Mesh.NumberOfFaces; ++f)
      {
        EXPECT_EQ(next.Mesh.GetSize(f), steps[step].Mesh.GetSize(f));
        EXPECT_TRUE(IsNear(GetCentre(steps[step].Mesh, f, points), GetCentre(next.Mesh, f, moved)));
      }
      const auto carriers = steps.GetCarriers(step);
      ASSERT_EQ(static_cast<vtkIdType>(carriers.size()), next.Mesh.NumberOfFaces);
      const int faces = static_cast<int>(steps[step].Mesh.NumberOfFaces);
      for (const auto& carrier : carriers)
      {
        EXPECT_TRUE(carrier.First >= 0 && carrier.First < faces);
        EXPECT_TRUE(carrier.Second >= -1 && carrier.Second < faces);
      }
      points = moved;
    }
  }
}

void ExpectChaikinBoundary(subdivision::SurfaceSchemeKind kind, int stepsOfOne)
{
  for (const Shape& shape : MakeShapes())
  {
    if (!shape.Orientation || shape.Name == "three sheets" || shape.Name == "pinched")
    {
      continue; // half-edges of the boundary do not follow one another
    }
    SCOPED_TRACE(shape.Name);
    const Steps steps(MakeLevel(shape.NumberOfVertices, shape.Polygons), kind, 2 * stepsOfOne);
    Points points = MakePoints(shape.NumberOfVertices);
    for (int first : { 0, stepsOfOne })
    {
      Points next = points;
      for (int step = first; step < first + stepsOfOne; ++step)
      {
        next = steps.Apply(step, next);
      }
      ExpectChaikin(
        GetBoundary(steps[first], points), GetBoundary(steps[first + stepsOfOne], next));
      points = next;
    }
  }
}

void ExpectRegularGrid(subdivision::SurfaceSchemeKind kind, double scale, std::size_t count)
{
  const Steps steps(MakeLevel(30, MakeQuads(5, 4)), kind, 2);
  Points points;
  for (int i = 0; i < 30; ++i)
  {
    points.push_back({ i % 6 * 1., i / 6 * 1., i % 6 * 2. - i / 6 });
  }
  points = steps.Apply(1, steps.Apply(0, points));
  std::set<std::pair<double, double>> seen;
  for (const auto& p : points)
  {
    EXPECT_NEAR(p[2], 2. * p[0] - p[1], 1e-14);
    if (p[0] > 1. && p[0] < 4. && p[1] > 1. && p[1] < 3.)
    {
      EXPECT_EQ(std::fmod(scale * p[0], 2.), 1.);
      EXPECT_EQ(std::fmod(scale * p[1], 2.), 1.);
      EXPECT_TRUE(seen.emplace(p[0], p[1]).second);
    }
  }
  EXPECT_EQ(seen.size(), count);
}

void ExpectLargeFans(subdivision::SurfaceSchemeKind kind, int levels)
{
  for (const bool open : { false, true })
  {
    const Steps steps(MakeLevel(2002, MakeFan(2000, open)), kind, levels);
    ExpectAverages(steps.GetRows(levels - 1));
    ExpectConforming(steps[levels]);
    EXPECT_EQ(GetEuler(steps[levels]), 1);
  }
}

}
