// SPDX-License-Identifier: BSD-3-Clause
// Which tetrahedra hold points, against a look at every tetrahedron.
#include "Precompiled.h"

#include "Core/Solids/Location/SimplexTree.h"

#include "Core/Solids/Location/TetFrame.h"

namespace
{

using subdivision::Buffer;
using subdivision::HoldTolerances;
using subdivision::PlaceInSimplex;
using subdivision::SimplexTree;

using Points = std::vector<std::array<double, 3>>;

struct Mesh
{
  Points Corners;
  std::vector<std::array<int, 4>> Tets;
};

/// Tetrahedra between random points: they overlap as they like. `flatness`: how thin they are.
Mesh MakeRandomMesh(int points, int tets, double flatness, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::uniform_int_distribution<int> id(0, points - 1);
  Mesh mesh;
  for (int i = 0; i < points; ++i)
  {
    mesh.Corners.push_back(
      { coordinate(random), coordinate(random), flatness * coordinate(random) });
  }
  for (int i = 0; i < tets; ++i)
  {
    mesh.Tets.push_back({ id(random), id(random), id(random), id(random) });
  }
  return mesh;
}

/// A lattice of n^3 cubes of 6 tetrahedra, whose points are moved a little.
Mesh MakeLattice(int n, double noise)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> move(-noise / n, noise / n);
  Mesh mesh;
  auto get = [n](const int(&p)[3]) { return (p[2] * (n + 1) + p[1]) * (n + 1) + p[0]; };
  for (int i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i)
  {
    const int place[3] = { i % (n + 1), i / (n + 1) % (n + 1), i / (n + 1) / (n + 1) };
    mesh.Corners.emplace_back();
    for (int c = 0; c < 3; ++c)
    {
      mesh.Corners.back()[c] = 1. * place[c] / n + move(random);
    }
  }
  const int orders[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  for (int i = 0; i < n * n * n; ++i)
  {
    for (const auto& order : orders)
    {
      int place[3] = { i % n, i / n % n, i / n / n };
      std::array<int, 4> tet = { get(place), 0, 0, 0 };
      for (int k = 0; k < 3; ++k)
      {
        ++place[order[k]];
        tet[k + 1] = get(place);
      }
      mesh.Tets.push_back(tet);
    }
  }
  return mesh;
}

/// Compares places with those that a look at every tetrahedron finds, bit by bit; returns how many
/// points are inside.
int Compare(const Mesh& mesh, const Points& points, const HoldTolerances& tolerances)
{
  Buffer<int> corners(static_cast<vtkIdType>(4 * mesh.Tets.size()));
  for (std::size_t i = 0; i < mesh.Tets.size(); ++i)
  {
    std::copy(mesh.Tets[i].begin(), mesh.Tets[i].end(), corners.data() + 4 * i);
  }
  const SimplexTree tree(mesh.Corners.empty() ? nullptr : mesh.Corners[0].data(), 4, corners);
  EXPECT_EQ(tree.GetNumberOfSimplices(), static_cast<vtkIdType>(mesh.Tets.size()));
  // Groups of all sizes, of neighbours and of points that are anywhere.
  std::vector<PlaceInSimplex> answers(points.size());
  for (std::size_t p = 0, size = 1; p < points.size(); p += size)
  {
    size = std::min<std::size_t>(size % SimplexTree::MostAtOnce + 1, points.size() - p);
    tree.FindHolding(reinterpret_cast<const double(*)[3]>(points[p].data()), static_cast<int>(size),
      tolerances, &answers[p]);
  }
  int inside = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    int expected = -1;
    double wanted[4] = {};
    for (double tolerance : { tolerances.Tight, tolerances.Loose })
    {
      for (std::size_t t = 0; t < mesh.Tets.size() && expected < 0; ++t)
      {
        const double* places[4];
        for (int k = 0; k < 4; ++k)
        {
          places[k] = mesh.Corners[static_cast<std::size_t>(mesh.Tets[t][k])].data();
        }
        if (std::isfinite(points[p][0]) &&
          subdivision::FindWeightsInTet(places, points[p].data(), wanted) &&
          *std::min_element(wanted, wanted + 4) >= -tolerance)
        {
          expected = static_cast<int>(t);
        }
      }
    }
    const PlaceInSimplex& found = answers[p];
    if (expected != found.Simplex)
    {
      ADD_FAILURE() << "point " << p << " is in " << expected << ", not " << found.Simplex;
      return inside;
    }
    if (expected >= 0)
    {
      ++inside;
      EXPECT_TRUE(std::equal(found.Weights, found.Weights + 4, wanted)) << "point " << p;
    }
  }
  return inside;
}

Points MakeRandomPoints(int size, double width, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-width, width);
  Points points;
  for (int i = 0; i < size; ++i)
  {
    points.push_back({ coordinate(random), coordinate(random), coordinate(random) });
  }
  return points;
}

}

TEST(CoreHoldingTets, FindsTheFirstTetrahedronThatHoldsAPoint)
{
  for (int size : { 1, 2, 8, 9, 65, 600 })
  {
    const Mesh mesh = MakeRandomMesh(60, size, 1., static_cast<unsigned>(size));
    Points points = MakeRandomPoints(3000, 1.1, 3);
    points.insert(points.end(), mesh.Corners.begin(), mesh.Corners.end());
    const int inside = Compare(mesh, points, { 1e-10, 1e-10 });
    EXPECT_TRUE(size < 600 || inside > 1000) << inside;
  }
}

TEST(CoreHoldingTets, ThinTetrahedra)
{
  for (double flatness : { 1e-3, 1e-6, 1e-9, 1e-11 })
  {
    const Mesh mesh = MakeRandomMesh(40, 100, flatness, 5);
    Points points = MakeRandomPoints(2000, 1., 4);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i][2] *= (i % 2 == 0 ? 1. : 3.) * flatness;
    }
    EXPECT_GT(Compare(mesh, points, { 1e-10, 1e-5 }), 100);
  }
}

TEST(CoreHoldingTets, SharedFacesAndTolerances)
{
  // Points on faces, edges and corners of many tetrahedra, and a little beside the boundary.
  const Mesh mesh = MakeLattice(6, 0.);
  Points points;
  for (double beside : { 0., 1e-12, 1e-8, 1e-4 })
  {
    for (const auto& corner : mesh.Corners)
    {
      points.push_back(corner);
      points.push_back({ corner[0] - beside, corner[1] + 1. / 12., corner[2] });
      points.push_back({ corner[0] + 1. / 18., corner[1] + 1. / 18., corner[2] + beside });
    }
  }
  const int tight = Compare(mesh, points, { 1e-10, 1e-10 });
  const int loose = Compare(mesh, points, { 1e-10, 1e-5 });
  EXPECT_GT(tight, 1000);
  EXPECT_GT(loose, tight);
}

TEST(CoreHoldingTets, PointsInClustersLinesAndPlanes)
{
  const Mesh mesh = MakeLattice(4, 0.3);
  for (const char* what : { "cluster", "line", "plane", "equal", "far" })
  {
    Points points = MakeRandomPoints(20000, 0.5, 7);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      auto& x = points[i];
      for (int c = 0; c < 3; ++c)
      {
        x[c] += 0.5;
        x[c] = what == std::string("cluster") && i % 16 > 0 ? 0.4 + 1e-7 * x[c]
          : what == std::string("line") && c > 0            ? 0.43
          : what == std::string("plane") && c > 1           ? 0.43
          : what == std::string("equal")                    ? 0.43
          : what == std::string("far") && i % 5 == 0        ? 1e300 * x[c]
                                                            : x[c];
      }
    }
    points[17][0] = std::numeric_limits<double>::quiet_NaN();
    points[18][0] = std::numeric_limits<double>::infinity();
    EXPECT_GT(Compare(mesh, points, { 1e-10, 1e-5 }), 10000) << what;
  }
}

TEST(CoreHoldingTets, ManyPointsInEachTetrahedronAnywhere)
{
  // Near zero and far from it, in meshes that are small, large, or far longer than wide.
  const double shifts[][3] = { { 0., 0., 0. }, { 1e6, -1e3, 3. }, { -1e9, 0., 1e-3 } };
  const double scales[][3] = { { 1., 1., 1. }, { 1e-100, 1e-100, 1e-100 }, { 1e90, 1e90, 1e90 },
    { 1e4, 1., 1e-4 } };
  for (const auto& shift : shifts)
  {
    for (const auto& scale : scales)
    {
      Mesh mesh = MakeLattice(3, 0.3);
      Points points = MakeRandomPoints(6000, 0.45, 11);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        for (int c = 0; c < 3; ++c) // on planes of the lattice, too
        {
          points[i][c] =
            i % 7 == 0 ? std::round(6. * (points[i][c] + 0.5)) / 6. : points[i][c] + 0.5;
        }
      }
      for (Points* list : { &mesh.Corners, &points })
      {
        for (auto& x : *list)
        {
          for (int c = 0; c < 3; ++c)
          {
            x[c] = scale[c] * (x[c] + (scale[c] == 1. ? shift[c] : 0.));
          }
        }
      }
      EXPECT_GT(Compare(mesh, points, { 1e-10, 1e-5 }), 5000) << shift[0] << " " << scale[0];
    }
  }
}

TEST(CoreHoldingTets, PointsNextToZero)
{
  // Of distances that have no inverse.
  Mesh mesh = MakeLattice(2, 0.);
  for (auto& corner : mesh.Corners)
  {
    for (double& x : corner)
    {
      x -= 0.5;
    }
  }
  Points points = MakeRandomPoints(3000, 1., 12);
  for (auto& point : points)
  {
    for (double& x : point)
    {
      x *= 1e-310;
    }
  }
  EXPECT_EQ(Compare(mesh, points, { 1e-10, 1e-10 }), 3000);
  // The smallest number apart.
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      points[i][c] = (i >> c & 1) == 0 ? 0. : std::numeric_limits<double>::denorm_min();
    }
  }
  EXPECT_EQ(Compare(mesh, points, { 1e-10, 1e-10 }), 3000);
}

TEST(CoreHoldingTets, PointsInTheBoxOfAFarCell)
{
  // A flat cell makes the box so wide that halves of it have no square.
  Mesh mesh = MakeLattice(2, 0.);
  Points points = MakeRandomPoints(900, 0.4, 13);
  for (auto& point : points)
  {
    for (double& x : point)
    {
      x += 0.5;
    }
  }
  for (double far : { 1e200, 1e304, 1.7e308 })
  {
    const auto first = static_cast<int>(mesh.Corners.size());
    mesh.Corners.insert(mesh.Corners.end(), { { far, far, far }, { -far, -far, -far } });
    mesh.Tets.push_back({ first, first + 1, first, first + 1 });
    points.push_back({ 0.9 * far, -0.9 * far, 0. });
    points.push_back({ -0.9 * far, 0.5, 0.9 * far });
    EXPECT_EQ(Compare(mesh, points, { 1e-10, 1e-10 }), 900) << far;
  }
}

TEST(CoreHoldingTets, FlatCellsAndNoCells)
{
  const Points points = { { 0.3, 0.2, 0. }, { 0., 0., 0. } };
  EXPECT_EQ(Compare({}, points, { 1e-10, 1e-10 }), 0);
  EXPECT_EQ(Compare(MakeLattice(1, 0.), {}, { 1e-10, 1e-10 }), 0);
  const Mesh flat = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
    { { 0, 1, 2, 3 }, { 0, 0, 0, 0 } } };
  EXPECT_EQ(Compare(flat, points, { 1e-10, 1e-10 }), 0);
}
