// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12 in the rules of d = 2: weights of edges that end on curves and at corners.
#include "CoreZoo.h"

#include "Core/Rules/Pi.h"

using namespace coretest;

namespace
{

StrataOptions Modify(std::initializer_list<double> angles = {})
{
  StrataOptions options;
  options.ModifiedBoundary = true;
  if (angles.size() > 0)
  {
    options.CornerAngles = Buffer<double>(static_cast<vtkIdType>(angles.size()));
    std::copy(angles.begin(), angles.end(), options.CornerAngles.begin());
  }
  return options;
}

/// The row of the edge between two vertices: weights by vertex.
std::map<int, double> FindRow(const Level<int>& level, int a, int b)
{
  const Matrix matrix = MakeMatrix(CopyStencils(level));
  std::map<int, double> row;
  const int edge = FindEdge(level.Complex, a, b);
  EXPECT_GE(edge, 0);
  for (int v = 0; v < level.Complex.NumberOfVertices; ++v)
  {
    const double weight = matrix[level.Complex.NumberOfVertices + edge][v];
    if (weight != 0.)
    {
      row[v] = weight;
    }
  }
  return row;
}

void ExpectRow(const std::map<int, double>& row, const std::map<int, double>& expected)
{
  ASSERT_EQ(row.size(), expected.size());
  for (const auto& [vertex, weight] : expected)
  {
    ASSERT_EQ(row.count(vertex), 1u) << vertex;
    EXPECT_NEAR(row.at(vertex), weight, 1e-15) << vertex;
  }
}

/// Around vertex 0 k triangles, around them a second ring, so that the first ring is smooth.
Mesh MakeHalfDisk(int k)
{
  Mesh mesh("HalfDisk");
  mesh.AddPoint(0., 0., 0.);
  for (int ring = 1; ring <= 2; ++ring)
  {
    for (int i = 0; i <= k; ++i)
    {
      mesh.AddPoint(ring * std::cos(Pi * i / k), ring * std::sin(Pi * i / k), 0.1 * ring * i);
    }
  }
  for (int i = 1; i <= k; ++i)
  {
    mesh.AddCell({ 0, i, i + 1 });
    mesh.AddCell({ i, i + k + 1, i + 1 });
    mesh.AddCell({ i + 1, i + k + 1, i + k + 2 });
  }
  return mesh;
}

double Gamma(double t)
{
  return 0.5 - std::cos(t) / 4.;
}

}

TEST(CoreSectors, EdgesNextToABoundary)
{
  for (int k = 2; k <= 12; ++k)
  {
    SCOPED_TRACE(std::to_string(k) + " triangles");
    const Level<int> level = Build<int>(MakeHalfDisk(k).Cells, {}, Modify()).Level;
    const double g = Gamma(Pi / k);
    for (int i = 2; i <= k; ++i)
    {
      ExpectRow(
        FindRow(level, 0, i), { { 0, 0.75 - g }, { i, g }, { i - 1, 0.125 }, { i + 1, 0.125 } });
    }
    EXPECT_EQ(level.Strata.Sectors.empty() ? 3 : k, k); // regular ones keep all bits
  }
}

TEST(CoreSectors, BothEndsOnABoundary)
{
  // An edge across a strip: 4 triangles at vertex 0, 5 at vertex 1.
  Mesh mesh("Strip");
  mesh.AddCells(
    { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 4 }, { 0, 5, 3 }, { 1, 6, 2 }, { 1, 3, 7 }, { 1, 7, 8 } });
  mesh.Cells.NumberOfPoints = 9;
  const Level<int> level = Build<int>(mesh.Cells, {}, Modify()).Level;
  const double g[2] = { Gamma(Pi / 4.), Gamma(Pi / 5.) };
  ExpectRow(FindRow(level, 0, 1),
    { { 0, (0.75 - g[0] + g[1]) / 2. }, { 1, (0.75 - g[1] + g[0]) / 2. }, { 2, 0.125 },
      { 3, 0.125 } });
}

TEST(CoreSectors, EachSideOfACreaseHasItsOwn)
{
  // Eight triangles around vertex 0; the crease leaves 3 on one side and 5 on the other.
  Mesh mesh = MakeFan("Crease", 8, true);
  mesh.Singular = { { 0, 1 }, { 0, 4 } };
  const Level<int> level = Build<int>(mesh.Cells, mesh.Singular, Modify()).Level;
  // The rim is a boundary of two triangles at each vertex.
  const double rim = Gamma(Pi / 2.);
  const auto mean = [&](double g) { return (0.75 - g + rim) / 2.; };
  ExpectRow(FindRow(level, 0, 2),
    { { 0, mean(0.375) }, { 2, 0.75 - mean(0.375) }, { 1, 0.125 }, { 3, 0.125 } });
  ExpectRow(FindRow(level, 0, 6),
    { { 0, mean(Gamma(Pi / 5.)) }, { 6, 0.75 - mean(Gamma(Pi / 5.)) }, { 5, 0.125 },
      { 7, 0.125 } });
}

TEST(CoreSectors, CornersFollowTheirAngles)
{
  Mesh mesh = MakeHalfDisk(4);
  mesh.Singular = { { 0 } };
  // Without an angle, or with one that is not a number, a corner has the plain rule.
  const auto plain = FindRow(Build<int>(mesh.Cells, mesh.Singular).Level, 0, 3);
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const double angle : { -1., none })
  {
    const auto options = Modify({ angle, 1., 1., 1., 1., 1., 1., 1., 1., 1., 1. });
    const Level<int> level = Build<int>(mesh.Cells, mesh.Singular, options).Level;
    EXPECT_TRUE(level.Strata.Sectors.empty() || FindRow(level, 0, 3) == plain);
    ExpectRow(FindRow(level, 0, 3), plain);
  }
  const auto row = [&](double angle)
  {
    const auto options = Modify({ angle, -1., -1., -1., -1., -1., -1., -1., -1., -1., -1. });
    return FindRow(Build<int>(mesh.Cells, mesh.Singular, options).Level, 0, 3);
  };
  const double g = Gamma(2. / 4.);
  ExpectRow(row(2.), { { 0, 0.75 - g }, { 3, g }, { 2, 0.125 }, { 4, 0.125 } });
  // Angles near 0, pi and 2 pi are clamped; pi itself is convex.
  EXPECT_EQ(row(0.), row(Pi / 8.));
  EXPECT_EQ(row(Pi), row(7. * Pi / 8.));
  EXPECT_EQ(row(3.2), row(9. * Pi / 8.));
  EXPECT_EQ(row(6.3), row(15. * Pi / 8.));
  // A concave corner pulls new points towards the plane of its two boundary edges.
  const double alpha = 4.;
  const double h = Gamma(alpha / 4.);
  const double third = 0.5 + (std::cos(Pi / 4.) - std::cos(alpha / 4.)) / 4.;
  const double s = 1. - 0.25 / third;
  const double t = 2. * alpha / 4.; // of the middle edge
  const double first = (std::cos(t) - std::sin(t) * std::cos(alpha) / std::sin(alpha)) / 2.;
  const double last = std::sin(t) / std::sin(alpha) / 2.;
  ExpectRow(row(alpha),
    { { 0, (1. - s) * (0.75 - h) + s * (1. - first - last) }, { 3, (1. - s) * h },
      { 2, (1. - s) / 8. }, { 4, (1. - s) / 8. }, { 1, s * first }, { 5, s * last } });
}

TEST(CoreSectors, BoundariesOfSolidsAreSurfaces)
{
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    const Level<int> level = Build<int>(mesh.Cells, mesh.Singular, Modify()).Level;
    // The list ascends, names surface edges only, and rows sum to 1.
    const auto& sectors = level.Strata.Sectors;
    for (std::size_t i = 0; i < sectors.size(); ++i)
    {
      EXPECT_EQ(level.Strata.Edges[sectors[i].Edge].GetRule(), Rule::Surface);
      const int end = level.Complex.EdgeVertices[2 * sectors[i].Edge + sectors[i].End];
      EXPECT_EQ(level.Strata.Vertices[end].GetRule(), Rule::Curve);
      EXPECT_TRUE(i == 0 ||
        std::make_pair(sectors[i - 1].Edge, sectors[i - 1].End) <
          std::make_pair(sectors[i].Edge, sectors[i].End));
    }
    for (const auto& row : MakeMatrix(CopyStencils(level)))
    {
      EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.), 1., 1e-14);
    }
  }
}

/// What a step hands on is what a search on the refined mesh finds.
TEST(CoreSectors, ChildrenInheritThem)
{
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const bool hasAngles : { false, true })
    {
      SCOPED_TRACE(mesh.Name);
      StrataOptions options = Modify();
      const vtkIdType points = mesh.Cells.NumberOfPoints;
      if (hasAngles)
      {
        options.CornerAngles = Buffer<double>(points);
        for (vtkIdType i = 0; i < points; ++i)
        {
          options.CornerAngles[i] = i % 3 == 0 ? -1. : 1. + static_cast<double>(i % 5);
        }
      }
      const auto control = Build<int>(mesh.Cells, mesh.Singular, options);
      const auto next = RefineOnce(control);
      const auto inherited = RefineOnce(next).Level.Strata.Sectors;
      // Rules of joints are those of the control mesh, so that a search is for meshes without.
      const auto hasJoint = [](const auto& strata)
      { return std::any_of(strata.begin(), strata.end(), [](Stratum s) { return s.GetType(); }); };
      if (hasJoint(control.Level.Strata.Vertices) || hasJoint(control.Level.Strata.Edges))
      {
        continue;
      }
      StrataOptions again = Modify();
      const vtkIdType size = next.Level.Complex.NumberOfVertices;
      again.CornerAngles = Buffer<double>(size, -1.);
      std::copy(
        options.CornerAngles.begin(), options.CornerAngles.end(), again.CornerAngles.begin());
      const auto singular = RefineSingular(control.Level.Complex, mesh.Singular);
      const auto found = RefineOnce(Build<int>(ReadCells(next), singular, again)).Level;
      ASSERT_EQ(found.Strata.Sectors.size(), inherited.size());
      std::multiset<double> shifts[2];
      for (std::size_t i = 0; i < inherited.size(); ++i)
      {
        shifts[0].insert(found.Strata.Sectors[i].Shift + 100. * found.Strata.Sectors[i].Flatness);
        shifts[1].insert(inherited[i].Shift + 100. * inherited[i].Flatness);
      }
      EXPECT_EQ(shifts[0], shifts[1]);
    }
  }
}
