// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNearPoints.cxx
 * Groups of near points are those of an exhaustive search, in any order.
 */
#include "Precompiled.h"

#include "Private/Reading/NearPoints.h"

using namespace subdivision;

namespace
{

using Points = std::vector<std::array<double, 3>>;

std::vector<vtkIdType> FindAll(const Points& points, double tolerance)
{
  std::vector<vtkIdType> all(points.size());
  std::iota(all.begin(), all.end(), vtkIdType(0));
  const Buffer<vtkIdType> firsts = FindFirstOfNear(points[0].data(), all, tolerance, PointOrder{});
  return { firsts.begin(), firsts.end() };
}

double GetDistance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Lowers the first of each until nothing changes.
std::vector<vtkIdType> SearchAll(const Points& points, double tolerance)
{
  std::vector<vtkIdType> firsts(points.size());
  std::iota(firsts.begin(), firsts.end(), vtkIdType(0));
  for (bool changes = true; changes;)
  {
    changes = false;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        if (firsts[k] < firsts[i] && GetDistance(points[i], points[k]) <= tolerance)
        {
          firsts[i] = firsts[k];
          changes = true;
        }
      }
    }
  }
  return firsts;
}

Points MakeRandom(unsigned seed, int size, double step)
{
  std::mt19937 random(seed);
  Points points(size);
  for (auto& point : points)
  {
    for (double& x : point)
    {
      x = step * static_cast<double>(random() % 40) + 1e-3 * static_cast<double>(random() % 7);
    }
  }
  return points;
}

}

TEST(NearPoints, AreThoseOfAnExhaustiveSearch)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const Points points = MakeRandom(seed, 400, seed % 2 ? 0.02 : -0.05);
    for (const double tolerance : { 0., 1e-3, 0.004, 0.021, 0.05, 0.1 })
    {
      EXPECT_EQ(FindAll(points, tolerance), SearchAll(points, tolerance))
        << "seed " << seed << ", tolerance " << tolerance;
    }
  }
}

TEST(NearPoints, AChainIsOneGroupInAnyOrder)
{
  Points chain;
  for (int i = 0; i < 50; ++i)
  {
    chain.push_back({ 0.9 * i, 0., 1. });
  }
  std::mt19937 random(3);
  for (int turn = 0; turn < 10; ++turn)
  {
    std::shuffle(chain.begin(), chain.end(), random);
    EXPECT_EQ(FindAll(chain, 1.), std::vector<vtkIdType>(50, 0));
    EXPECT_EQ(FindAll(chain, 0.8), SearchAll(chain, 0.8));
  }
}

TEST(NearPoints, ZeroHasNoSignAndPointsThatAreNotFiniteAreAlone)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Points points = { { 0., 0., 0. }, { -0., 0., -0. }, { nan, 0., 0. }, { nan, 0., 0. },
    { infinite, 0., 0. }, { infinite, 0., 0. }, { 1., 1., 1. } };
  for (const double tolerance : { 0., 0.1 })
  {
    EXPECT_EQ(FindAll(points, tolerance), (std::vector<vtkIdType>{ 0, 0, 2, 3, 4, 5, 6 }));
  }
}

TEST(NearPoints, VeryLargeAndVerySmallOnes)
{
  for (const double scale : { 1e300, 1e-300 })
  {
    const Points points = { { scale, 0., 0. }, { scale * (1. + 1e-7), 0., 0. },
      { scale * (1. + 1e-3), 0., 0. } };
    EXPECT_EQ(FindAll(points, 1e-6 * scale), (std::vector<vtkIdType>{ 0, 0, 2 }));
  }
  // A tolerance that coordinates cannot tell from 0.
  EXPECT_EQ(FindAll({ { 1., 0., 0. }, { 2., 0., 0. } }, 1e-300), (std::vector<vtkIdType>{ 0, 1 }));
}

TEST(NearPoints, TheOrderChoosesTheFirst)
{
  const Points points = { { 0., 0., 0. }, { 0., 0., 0. }, { 0., 0., 1e-9 } };
  const vtkIdType ids[3] = { 5, 4, 3 };
  for (const double tolerance : { 0., 1e-8 })
  {
    const Buffer<vtkIdType> firsts =
      FindFirstOfNear(points[0].data(), { 0, 1, 2 }, tolerance, PointOrder{ ids });
    const vtkIdType first = tolerance > 0. ? 2 : 1;
    EXPECT_EQ(firsts[0], first);
    EXPECT_EQ(firsts[1], first);
    EXPECT_EQ(firsts[2], 2);
  }
}

/// Sets that are dense and just too far apart take no time that is the square of their number.
TEST(NearPoints, ManyAtOnePlace)
{
  Points points(100000, { 0., 0., 0. });
  points.resize(200000, { 1., 0., 0. });
  const auto firsts = FindAll(points, 0.9);
  EXPECT_EQ(firsts.back(), 100000);
  EXPECT_EQ(std::count(firsts.begin(), firsts.end(), 0), 100000);
}
