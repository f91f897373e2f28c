// SPDX-License-Identifier: BSD-3-Clause
// sqrt(3): masks by their algebra, limits. TestSurfaceReplacedEdges.cxx has what 4-8 has, too.
#include "SurfaceTools.h"

namespace
{

using namespace surfacetools;

constexpr SurfaceSchemeKind Kind = SurfaceSchemeKind::SqrtThree;
const double pi = std::acos(-1.);

double GetRingWeight(int n)
{
  return (4. - 2. * std::cos(2. * pi / n)) / 9.;
}

TEST(SurfaceSqrtThree, SpectrumAroundInteriorVertices)
{
  for (int n = 3; n <= 12; ++n)
  {
    // Waves on the ring: 2 cos(pi m / n) / 3 (Kobbelt, eq. 4); the mean: 2/3 - a.
    for (int m = 1; m < n; ++m)
    {
      Model fan = MakeFan(n, false);
      for (int j = 0; j < n; ++j)
      {
        const double angle = 2. * pi * m * j / n;
        fan.Points[1 + j] = { std::cos(angle), std::sin(angle), 0. };
      }
      Walk walk(fan, Kind);
      walk.Step();
      EXPECT_LT(GetDistance(walk.Points[0], { 0., 0., 0. }), 1e-14);
      const std::vector<int> ring = walk.GetNeighbours(0);
      ASSERT_EQ(ring.size(), static_cast<std::size_t>(n));
      for (int v : ring)
      {
        EXPECT_NEAR(std::hypot(walk.Points[v][0], walk.Points[v][1]),
          std::abs(2. * std::cos(pi * m / n) / 3.), 1e-14);
      }
    }
    Model fan = MakeFan(n, false);
    fan.Points = MakeRandomPoints(fan.Points.size(), 100u + n);
    Walk walk(fan, Kind);
    const Point limit = walk.GetLimit()[0];
    for (int step = 1; step <= 5; ++step)
    {
      const Point before = walk.Points[0];
      walk.Step();
      const double left = 2. / 3. - GetRingWeight(n);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(walk.Points[0][c] - limit[c], left * (before[c] - limit[c]), 1e-14);
      }
    }
    EXPECT_GT(2. * std::cos(pi / n) / 3., std::abs(2. / 3. - GetRingWeight(n)));
  }
}

TEST(SurfaceSqrtThree, SpectrumAroundBoundaryVertices)
{
  for (int k = 2; k <= 8; ++k)
  {
    for (int m = 1; m < k; ++m)
    {
      Model fan = MakeFan(k, true);
      for (int j = 0; j <= k; ++j)
      {
        fan.Points[1 + j] = { 0., 0., j == 0 || j == k ? 0. : std::sin(pi * m * j / k) };
      }
      Walk walk(fan, Kind);
      walk.Step();
      walk.Step();
      std::multiset<long> expected{ 0, 0 };
      auto round = [](double value) { return std::lround(1e12 * value); };
      // The first wave shrinks to a third, as the curve does.
      const double value = (1. + std::cos(pi * m / k)) / (1. + std::cos(pi / k)) / 3.;
      for (int j = 1; j < k; ++j)
      {
        expected.insert(round(value * std::sin(pi * m * j / k)));
      }
      std::multiset<long> found;
      for (int v : walk.GetNeighbours(0))
      {
        found.insert(round(walk.Points[v][2]));
      }
      ASSERT_EQ(found.size(), expected.size());
      EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(),
        [](long a, long b) { return std::abs(a - b) <= 1; }))
        << k << " " << m;
    }
  }
}

TEST(SurfaceSqrtThree, CurvesAreCubicSplinesInThirds)
{
  Model line;
  line.Points = MakeRandomPoints(5, 7);
  line.Lines = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 } };
  Walk walk(line, Kind);
  const std::vector<Point> limit = walk.GetLimit();
  walk.Step();
  EXPECT_EQ(walk.Points, line.Points);
  for (int step = 1; step < 5; ++step)
  {
    const std::vector<Point> before = walk.Points;
    walk.Step();
    for (int c = 0; c < 3 && step % 2 == 1; ++c)
    {
      EXPECT_NEAR(walk.Points[2][c] - limit[2][c], (before[2][c] - limit[2][c]) / 9., 1e-14);
    }
  }
  EXPECT_EQ(walk.Level.Mesh.GetNumberOfEdges(), 36);
  EXPECT_EQ(walk.Points[0], line.Points[0]);
}

TEST(SurfaceSqrtThree, LimitsAreThoseOfTheNextLevel)
{
  for (const auto& entry : MakeZoo(true))
  {
    SCOPED_TRACE(entry.first);
    Walk walk(entry.second, Kind);
    for (int step = 0; step < 4; ++step)
    {
      const std::vector<Point> limit = walk.GetLimit();
      walk.Step();
      const std::vector<Point> next = walk.GetLimit();
      for (std::size_t v = 0; v < limit.size(); ++v)
      {
        EXPECT_LT(GetDistance(limit[v], next[v]), 1e-14) << step << " " << v;
      }
    }
  }
}

TEST(SurfaceSqrtThree, TwelveLevelsComeCloseToTheLimit)
{
  Model fan = MakeFan(5, false);
  fan.Faces.resize(2); // a boundary too; 12 levels of more would be large
  fan.Points = MakeRandomPoints(fan.Points.size(), 3);
  Walk walk(fan, Kind);
  const std::vector<Point> start = walk.GetLimit();
  walk.Step();
  const std::vector<Point> first = walk.GetLimit();
  for (int step = 1; step < 12; ++step)
  {
    walk.Step();
  }
  for (std::size_t v = 0; v < first.size(); ++v)
  {
    EXPECT_LT(GetDistance(walk.Points[v], first[v]), 2e-5); // 3^-10
    EXPECT_TRUE(v >= start.size() || 1e-14 > GetDistance(start[v], first[v]));
  }
}

/// Tangents of one level and of the next span the same planes.
TEST(SurfaceSqrtThree, TangentPlanesAreThoseOfTheNextLevels)
{
  auto cross = [](const Point& a, const Point& b)
  {
    return Point{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  auto getNormals = [&](const Walk& walk)
  {
    const std::vector<Point> a = walk.GetLimit(LimitKind::Tangent1);
    const std::vector<Point> b = walk.GetLimit(LimitKind::Tangent2);
    std::vector<Point> normals(a.size());
    for (std::size_t v = 0; v < a.size(); ++v)
    {
      normals[v] = cross(a[v], b[v]);
      const double length = std::hypot(normals[v][0], normals[v][1], normals[v][2]);
      for (double& component : normals[v])
      {
        component /= length > 0. ? length : 1.;
      }
    }
    return normals;
  };
  for (int k = 1; k <= 6; ++k)
  {
    for (bool open : { false, true })
    {
      SCOPED_TRACE(k);
      Model fan = MakeFan(open ? k : k + 2, open);
      const std::vector<Point> noise = MakeRandomPoints(fan.Points.size(), 20u + k);
      for (std::size_t v = 0; v < noise.size(); ++v)
      {
        fan.Points[v][2] = noise[v][2];
      }
      Walk walk(fan, Kind);
      const std::vector<Point> normals = getNormals(walk);
      EXPECT_GT(normals[0][2], 0.);
      for (int step = 0; step < 4; ++step)
      {
        walk.Step();
        EXPECT_LT(GetDistance(getNormals(walk)[0], normals[0]), 1e-12) << step;
      }
    }
  }
}

TEST(SurfaceSqrtThree, CellsTakeTheirDataFromTheFirstOfTheirParents)
{
  const auto input = MakeInput(MakeZoo(true)["tetrahedron"]);
  vtkNew<vtkFloatArray> data;
  data->SetName("face");
  for (int f = 0; f < 4; ++f)
  {
    data->InsertNextValue(static_cast<float>(f));
  }
  input->GetCellData()->AddArray(data);
  const auto output = RunFilter(input, vtkSurfaceSubdivision::SQRT_THREE, 1);
  std::map<double, int> counts;
  for (vtkIdType c = 0; c < 12; ++c)
  {
    ++counts[output->GetCellData()->GetArray("face")->GetComponent(c, 0)];
  }
  // Of the six edges, three have face 0, two more face 1, the last one face 2.
  EXPECT_EQ(counts, (std::map<double, int>{ { 0., 6 }, { 1., 4 }, { 2., 2 } }));
}

}
