// SPDX-License-Identifier: BSD-3-Clause
// The search tree against a look at every simplex.
#include "Precompiled.h"

#include "Core/Solids/Location/SimplexTree.h"

#include "Core/Solids/Location/TetFrame.h"

namespace
{

using subdivision::Buffer;
using subdivision::PlaceInSimplex;
using subdivision::SimplexTree;

struct Mesh
{
  std::vector<double> Points;
  std::vector<int> Ids;
  int Corners;
  mutable Buffer<int> Kept; ///< of the tree

  SimplexTree MakeTree() const
  {
    this->Kept = Buffer<int>(static_cast<vtkIdType>(this->Ids.size()));
    std::copy(this->Ids.begin(), this->Ids.end(), this->Kept.begin());
    return SimplexTree(this->Points.data(), this->Corners, this->Kept);
  }
  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->Ids.size()) / this->Corners; }
  void Get(vtkIdType simplex, const double* corners[4]) const
  {
    for (int k = 0; k < this->Corners; ++k)
    {
      corners[k] = this->Points.data() + 3 * this->Ids[this->Corners * simplex + k];
    }
  }
};

/// Simplices between random points: they overlap as they like.
Mesh MakeRandomMesh(int points, int simplices, int corners, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::uniform_int_distribution<int> id(0, points - 1);
  Mesh mesh;
  mesh.Corners = corners;
  for (int i = 0; i < 3 * points; ++i)
  {
    mesh.Points.push_back(coordinate(random));
  }
  for (int i = 0; i < corners * simplices; ++i)
  {
    mesh.Ids.push_back(id(random));
  }
  return mesh;
}

std::array<double, 3> Combine(const Mesh& mesh, const PlaceInSimplex& place)
{
  const double* corners[4];
  mesh.Get(place.Simplex, corners);
  std::array<double, 3> x = { 0., 0., 0. };
  for (int k = 0; k < mesh.Corners; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      x[c] += place.Weights[k] * corners[k][c];
    }
  }
  return x;
}

double Distance2(const double* a, const double* b)
{
  double sum = 0.;
  for (int c = 0; c < 3; ++c)
  {
    sum += (a[c] - b[c]) * (a[c] - b[c]);
  }
  return sum;
}

/// The distance to a triangle, by a fine grid of places in it: never smaller than the true one.
double SampleDistance2(const double* const corners[3], const double* x)
{
  constexpr int n = 60;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      double y[3];
      for (int c = 0; c < 3; ++c)
      {
        y[c] = (i * corners[0][c] + j * corners[1][c] + (n - i - j) * corners[2][c]) / n;
      }
      best = std::min(best, Distance2(x, y));
    }
  }
  return best;
}

}

TEST(CoreSimplexTree, FindsTheNearestPlace)
{
  for (int corners : { 3, 4 })
  {
    Mesh mesh = MakeRandomMesh(80, 40, corners, 11);
    if (corners == 3)
    {
      mesh.Ids[2] = mesh.Ids[1];               // a line
      mesh.Ids[4] = mesh.Ids[5] = mesh.Ids[3]; // a vertex
    }
    const SimplexTree tree = mesh.MakeTree();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-2., 2.);
    for (int i = 0; i < 60; ++i)
    {
      const double x[3] = { coordinate(random), coordinate(random), coordinate(random) };
      PlaceInSimplex place;
      double distance2 = 0.;
      ASSERT_TRUE(tree.FindNearest(x, place, distance2));
      const auto y = Combine(mesh, place);
      EXPECT_NEAR(Distance2(y.data(), x), distance2, 1e-12);
      for (double weight : place.Weights)
      {
        EXPECT_GE(weight, 0.);
      }
      double sampled = std::numeric_limits<double>::infinity();
      for (vtkIdType s = 0; s < mesh.GetSize(); ++s)
      {
        const double* all[4];
        mesh.Get(s, all);
        for (int omitted = 0; omitted < (corners == 4 ? 4 : 1); ++omitted)
        {
          const double* facet[3];
          for (int k = 0; k < 3; ++k)
          {
            facet[k] = all[corners == 4 && k >= omitted ? k + 1 : k];
          }
          sampled = std::min(sampled, SampleDistance2(facet, x));
        }
      }
      bool isInside = false;
      for (vtkIdType s = 0; s < mesh.GetSize() && corners == 4; ++s)
      {
        const double* all[4];
        double weights[4];
        mesh.Get(s, all);
        isInside = isInside ||
          (subdivision::FindWeightsInTet(all, x, weights) &&
            *std::min_element(weights, weights + 4) >= 0.);
      }
      if (!isInside)
      {
        EXPECT_LE(distance2, sampled + 1e-12);
        EXPECT_NEAR(std::sqrt(distance2), std::sqrt(sampled), 0.02);
      }
      else
      {
        EXPECT_LT(distance2, 1e-24);
      }
    }
  }
}

TEST(CoreSimplexTree, EqualAnswersComeFromTheFirst)
{
  Mesh mesh;
  mesh.Corners = 4;
  mesh.Points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1 };
  for (int i = 0; i < 9; ++i) // above and below the triangle 0 1 2, in turns
  {
    for (int id : { 0, 1, 2, i % 2 == 0 ? 3 : 4 })
    {
      mesh.Ids.push_back(id);
    }
  }
  const SimplexTree tree = mesh.MakeTree();
  PlaceInSimplex place;
  double distance2 = 0.;
  const double beside[3] = { 0.25, -3., 0. };
  EXPECT_TRUE(tree.FindNearest(beside, place, distance2));
  EXPECT_EQ(place.Simplex, 0);
  EXPECT_DOUBLE_EQ(distance2, 9.);
}

/// Far from a surface nearly all of it is equally near; what the search leaves out is not nearer.
TEST(CoreSimplexTree, IsExactFarFromASurface)
{
  constexpr int n = 24;
  Mesh sphere;
  sphere.Corners = 3;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double a = 3.141592653589793 * i / n;
      const double b = 2. * 3.141592653589793 * j / n;
      const double r = 1. + 0.05 * std::sin(5. * a) * std::sin(4. * b);
      for (const double x :
        { r * std::sin(a) * std::cos(b), r * std::sin(a) * std::sin(b), r * std::cos(a) })
      {
        sphere.Points.push_back(x);
      }
      const int next = (j + 1) % n;
      for (const int id : { i * n + j, (i + 1) * n + j, i * n + next, i * n + next, (i + 1) * n + j,
             (i + 1) * n + next })
      {
        i < n ? sphere.Ids.push_back(id) : void();
      }
    }
  }
  const SimplexTree tree = sphere.MakeTree();
  std::vector<Buffer<int>> ids;
  std::vector<SimplexTree> single; // trees of one triangle each
  for (vtkIdType i = 0; i < sphere.GetSize(); ++i)
  {
    ids.emplace_back(3);
    std::copy_n(sphere.Ids.begin() + 3 * i, 3, ids.back().begin());
    single.emplace_back(sphere.Points.data(), 3, ids.back());
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  for (int i = 0; i < 400; ++i)
  {
    const double scale = i % 4 == 0 ? 0.01 : i % 4 == 1 ? 0.6 : i % 4 == 2 ? 2. : 1e6;
    double x[3];
    std::generate(x, x + 3, [&] { return i == 0 ? 0. : scale * coordinate(random); });
    PlaceInSimplex place;
    PlaceInSimplex best;
    double distance2 = 0.;
    double least = std::numeric_limits<double>::infinity();
    ASSERT_TRUE(tree.FindNearest(x, place, distance2));
    for (std::size_t t = 0; t < single.size(); ++t)
    {
      PlaceInSimplex here;
      double there = 0.;
      single[t].FindNearest(x, here, there);
      if (there < least)
      {
        least = there;
        best = here;
        best.Simplex = static_cast<vtkIdType>(t);
      }
    }
    EXPECT_EQ(place.Simplex, best.Simplex) << i;
    EXPECT_EQ(distance2, least) << i;
    EXPECT_TRUE(std::equal(place.Weights, place.Weights + 4, best.Weights)) << i;
  }
}

TEST(CoreSimplexTree, FlatCellsAndNoCells)
{
  const Mesh nothing = { {}, {}, 4, {} };
  const double x[3] = { 0.3, 0.2, 0. };
  PlaceInSimplex place;
  double distance2 = 0.;
  EXPECT_FALSE(nothing.MakeTree().FindNearest(x, place, distance2));
  EXPECT_FALSE(SimplexTree().FindNearest(x, place, distance2));
  const Mesh flat = { { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 }, { 0, 1, 2, 3, 0, 0, 0, 0 }, 4, {} };
  EXPECT_TRUE(flat.MakeTree().FindNearest(x, place, distance2));
  EXPECT_NEAR(distance2, 0., 1e-30);
  const double* corners[4];
  flat.Get(0, corners);
  EXPECT_EQ(subdivision::GetOrientationOfTet(corners), 0);
}

TEST(CoreSimplexTree, GradientsAreDifferencesOfWeights)
{
  const Mesh mesh = MakeRandomMesh(4, 1, 4, 9);
  const Mesh tet = { mesh.Points, { 0, 1, 2, 3 }, 4, {} };
  const double* corners[4];
  tet.Get(0, corners);
  double gradients[4][3];
  ASSERT_TRUE(subdivision::FindGradientsInTet(corners, gradients));
  const double x[3] = { 0.3, -0.2, 0.1 };
  double weights[4];
  ASSERT_TRUE(subdivision::FindWeightsInTet(corners, x, weights));
  for (int c = 0; c < 3; ++c)
  {
    double y[3] = { x[0], x[1], x[2] };
    y[c] += 1.;
    double others[4];
    ASSERT_TRUE(subdivision::FindWeightsInTet(corners, y, others));
    for (int k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(
        gradients[k][c], others[k] - weights[k], 1e-12 * (1. + std::abs(gradients[k][c])));
    }
  }
}
