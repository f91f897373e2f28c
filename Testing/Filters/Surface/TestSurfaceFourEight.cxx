// SPDX-License-Identifier: BSD-3-Clause
// 4-8: incidences against a search, masks by their algebra, and the filter around it.
#include "SurfaceTools.h"

namespace
{

using namespace surfacetools;

constexpr SurfaceSchemeKind Kind = SurfaceSchemeKind::FourEight;

/// k sheets of quads around point 0, each n by n: point 0 has k faces, all others inside have four.
Model MakeSheets(int k, int n)
{
  Model model;
  model.Points.push_back({ 0., 0., 0. });
  // Sheet s has its axis s and what lies between that and the next one.
  auto getId = [=](int s, int x, int y) -> vtkIdType
  {
    if (x == 0 && y == 0)
    {
      return 0;
    }
    // On the axis of the next sheet, x = 0: there it is (y, 0).
    const int sheet = x == 0 ? (s + 1) % k : s;
    const int a = x == 0 ? y : x;
    const int b = x == 0 ? 0 : y;
    return 1 + sheet * n * (n + 1) + (a - 1) * (n + 1) + b;
  };
  model.Points.resize(static_cast<std::size_t>(1 + k * n * (n + 1)));
  const double turn = 2. * std::acos(-1.) / k;
  for (int s = 0; s < k; ++s)
  {
    for (int x = 0; x <= n; ++x)
    {
      for (int y = 0; y <= n; ++y)
      {
        model.Points[getId(s, x, y)] = { x * std::cos(s * turn) + y * std::cos(s * turn + turn),
          x * std::sin(s * turn) + y * std::sin(s * turn + turn), 0. };
      }
    }
    for (int x = 0; x < n; ++x)
    {
      for (int y = 0; y < n; ++y)
      {
        model.Faces.push_back(
          { getId(s, x, y), getId(s, x + 1, y), getId(s, x + 1, y + 1), getId(s, x, y + 1) });
      }
    }
  }
  return model;
}

TEST(SurfaceFourEight, StepsAreWhatASearchFinds)
{
  std::map<std::string, Model> zoo = MakeZoo(false);
  const std::map<std::string, Model> triangles = MakeZoo(true);
  for (const char* name : { "triangle", "moebius", "flipped fan", "touching tetrahedra" })
  {
    zoo[std::string("triangles: ") + name] = triangles.at(name);
  }
  for (const auto& entry : zoo)
  {
    SCOPED_TRACE(entry.first);
    Walk walk(entry.second, Kind);
    for (int step = 0; step < 5; ++step)
    {
      const vtkIdType euler = GetEuler(walk.Level.Mesh);
      CheckRows(walk);
      const SurfaceLevel<int> output = walk.Scheme->Refine(walk.Level, Depth::ForCounts);
      std::vector<int> faces(
        static_cast<std::size_t>(output.Mesh.GetFirstOfCounted(output.Mesh.NumberOfFaces)));
      walk.Scheme->WriteFaces(walk.Level, faces.data());
      walk.Step();
      EXPECT_EQ(GetEuler(walk.Level.Mesh), euler);
      CheckIncidences(walk.Level);
      const SurfaceLevel<int>& whole = walk.Level;
      EXPECT_EQ(faces, std::vector<int>(whole.Mesh.Vertices.begin(), whole.Mesh.Vertices.end()));
      ASSERT_EQ(output.Lines.size(), whole.Lines.size());
      EXPECT_TRUE(std::equal(output.Lines.begin(), output.Lines.end(), whole.Lines.begin()));
    }
  }
}

TEST(SurfaceFourEight, LinesStayConnected)
{
  CheckLines(Kind, false, 4);
}

TEST(SurfaceFourEight, CountsOfFaces)
{
  // An odd step makes a face of each edge, two steps make four of each quad.
  Walk walk(MakeSheet(4, 3, false, { 1., 0., 0. }, { 0., 1., 0. }), Kind);
  for (int round = 0; round < 3; ++round)
  {
    const vtkIdType quads = walk.Level.Mesh.NumberOfFaces;
    const vtkIdType edges = walk.Level.Mesh.GetNumberOfEdges();
    walk.Step();
    EXPECT_EQ(walk.Level.Mesh.NumberOfFaces, edges);
    walk.Step();
    EXPECT_EQ(walk.Level.Mesh.NumberOfFaces, 4 * quads);
    EXPECT_EQ(walk.Level.Mesh.Arity, 4);
  }
}

/// (1 + z1)^2 (1 + z2)^2 / 8: a new point is 4/8 of the old one there, 2/8 of each that is half a
/// diagonal away, 1/8 of each that is an edge away.
TEST(SurfaceFourEight, RegularMaskIsThatOfTheBoxSpline)
{
  Walk walk(MakeSheet(8, 8, false, { 1., 0., 0. }, { 0., 1., 0. }), Kind);
  double length = 1.;
  for (int step = 0; step < 4; ++step, length *= std::sqrt(0.5))
  {
    const RowBlock<int> rows = walk.GetRows();
    const std::vector<Point> next = Walk::Apply(rows, walk.Points);
    int checked = 0;
    for (std::size_t row = 0; row < next.size(); ++row)
    {
      if (std::max(std::abs(next[row][0] - 4.), std::abs(next[row][1] - 4.)) > 2.5)
      {
        continue;
      }
      ++checked;
      std::map<int, double> weights;
      for (std::size_t k = rows.GetBegin(row); k < rows.GetEnd(row); ++k)
      {
        weights[rows.GetColumns()[k]] += rows.GetWeights()[k];
      }
      for (std::size_t old = 0; old < walk.Points.size(); ++old)
      {
        const double distance =
          std::hypot(walk.Points[old][0] - next[row][0], walk.Points[old][1] - next[row][1]) /
          length;
        const double expected = 0.1 > distance ? 0.5
          : 0.1 > std::abs(distance - std::sqrt(0.5))
          ? 0.25
          : (0.1 > std::abs(distance - 1.) && row < walk.Points.size() ? 0.125 : 0.);
        EXPECT_NEAR(weights[static_cast<int>(old)], expected, 1e-15);
      }
    }
    EXPECT_GT(checked, 30);
    walk.Step();
  }
}

TEST(SurfaceFourEight, FlatGridsStayExact)
{
  Walk walk(MakeSheet(4, 3, false, { 1., 0., 0. }, { 0.25, 0.8, 0.5 }), Kind);
  for (int step = 0; step < 6; ++step)
  {
    const std::vector<Point> before = walk.Points;
    walk.Step();
    for (std::size_t v = 0; v < before.size(); ++v)
    {
      EXPECT_LT(GetDistance(walk.Points[v], before[v]), 1e-14) << step << " " << v;
    }
  }
}

TEST(SurfaceFourEight, LimitTotalsAreTheSameForEveryValence)
{
  for (int k = 3; k <= 8; ++k)
  {
    SCOPED_TRACE(k);
    Model model = MakeSheets(k, 3);
    // Indicators of the centre, of its edges' ends, of the other corners of its faces.
    for (Point& point : model.Points)
    {
      point = { 0., 0., 0. };
    }
    model.Points[0][0] = 1.;
    for (int s = 0; s < k; ++s)
    {
      model.Points[model.Faces[9 * s][1]][1] = 1.;
      model.Points[model.Faces[9 * s][2]][2] = 1.;
    }
    Walk walk(model, Kind);
    Point last{};
    Point extrapolated{};
    for (int step = 0; step < 10; ++step)
    {
      last = walk.Points[0];
      walk.Step();
      for (int c = 0; c < 3; ++c)
      {
        extrapolated[c] = 2. * walk.Points[0][c] - last[c]; // the slowest part is halved
      }
    }
    EXPECT_LT(GetDistance(extrapolated, { 35. / 120., 59. / 120., 22. / 120. }), 1e-3);
  }
}

TEST(SurfaceFourEight, SurfacesAreSmoothAtExtraordinaryVertices)
{
  // 1 > l1 = l2 > |l3|: the first wave shrinks alike in all directions, other waves faster.
  for (int k = 3; k <= 12; ++k)
  {
    SCOPED_TRACE(k);
    auto getRate = [k](int wave)
    {
      Model model = MakeSheets(k, 3);
      for (std::size_t v = 0; v < model.Points.size(); ++v)
      {
        const double radius = std::hypot(model.Points[v][0], model.Points[v][1]);
        const double angle = std::atan2(model.Points[v][1], model.Points[v][0]);
        model.Points[v] = { radius * std::cos(wave * angle), radius * std::sin(wave * angle),
          wave == 0 && v > 0 ? radius : 0. };
      }
      Walk walk(model, Kind);
      double radii[2] = {};
      for (int step = 0; step <= 8; ++step)
      {
        if (step >= 6 && step % 2 == 0)
        {
          double least = 1e300;
          double most = 0.;
          for (int v : walk.GetNeighbours(0))
          {
            const Point& p = walk.Points[v];
            const double radius =
              wave == 0 ? std::abs(p[2] - walk.Points[0][2]) : std::hypot(p[0], p[1]);
            least = std::min(least, radius);
            most = std::max(most, radius);
          }
          EXPECT_TRUE(wave != 1 || 1e-10 > most - least);
          radii[step == 8] = most;
        }
        walk.Step();
      }
      return radii[1] / radii[0]; // of two steps
    };
    const double first = getRate(1);
    EXPECT_LT(first, 1.);
    EXPECT_GT(first, 0.25);
    EXPECT_LT(getRate(0), 0.98 * first);
    for (int wave = 2; wave <= k / 2; ++wave)
    {
      EXPECT_LT(getRate(wave), 0.98 * first) << wave;
    }
  }
}

TEST(SurfaceFourEight, CreasesAreBoundariesOnBothSides)
{
  Model both = MakeSheet(3, 2, false, { 1., 0., 0. }, { 0., 1., 0. });
  both.Points = MakeRandomPoints(both.Points.size(), 9);
  both.Lines = { { 4, 5 }, { 5, 6 }, { 6, 7 } };
  Model half = both;
  half.Lines.clear();
  half.Faces.resize(3);
  half.Corners.insert(half.Corners.end(), { 4, 7 });
  Walk whole(both, Kind);
  Walk part(half, Kind);
  for (int step = 0; step < 6; ++step)
  {
    // The children of the half are the first ones of the whole.
    for (int c = 0; c < part.Level.Mesh.GetNumberOfCorners(); ++c)
    {
      EXPECT_LT(GetDistance(part.Points[part.Level.Mesh.Vertices[c]],
                  whole.Points[whole.Level.Mesh.Vertices[c]]),
        1e-14);
    }
    whole.Step();
    part.Step();
  }
}

TEST(SurfaceFourEight, CurvesAreCubicSplinesEverySecondStep)
{
  Model line;
  line.Points = MakeRandomPoints(5, 7);
  line.Lines = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 } };
  Walk walk(line, Kind);
  walk.Step();
  EXPECT_EQ(walk.Points, line.Points);
  walk.Step();
  ASSERT_EQ(walk.Points.size(), 9u);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(walk.Points[2][c],
      0.75 * line.Points[2][c] + 0.125 * (line.Points[1][c] + line.Points[3][c]), 1e-15);
    EXPECT_NEAR(walk.Points[5][c], 0.5 * (line.Points[0][c] + line.Points[1][c]), 1e-15);
  }
}

TEST(SurfaceFourEight, AnythingIsSubdivided)
{
  CheckRandomFaces(Kind, false);
}

TEST(SurfaceFourEight, FiltersInARowAreOneFilter)
{
  for (bool triangles : { false, true })
  {
    for (const auto& entry : MakeZoo(triangles))
    {
      SCOPED_TRACE(entry.first);
      CheckChaining(entry.second, vtkSurfaceSubdivision::FOUR_EIGHT);
    }
  }
}

TEST(SurfaceFourEight, FiltersInARowKeepFlags)
{
  CheckChainingOfFlags(false, vtkSurfaceSubdivision::FOUR_EIGHT);
}

TEST(SurfaceFourEight, ThreadsDoNotChangeTheResult)
{
  Model grid = MakeSheet(40, 40, false, { 1., 0., 0. }, { 0., 1., 0. });
  grid.Points = MakeRandomPoints(grid.Points.size(), 5);
  for (int i = 0; i < 20; ++i)
  {
    grid.Lines.push_back({ 42 * i, 42 * i + 1 });
  }
  CheckThreads(grid, vtkSurfaceSubdivision::FOUR_EIGHT, 4, false);
}

}
