// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSignOfChildren.cxx
 * The sign of the volumes of the children of tetrahedra, beside the orientation of each child.
 */
#include "Core/Solids/BoxSpline/SignOfChildren.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/Location/TetFrame.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace subdivision;

namespace
{

constexpr int Parents = 8;

/// Lattices of tetrahedra, each with points of its own, that are moved by up to `noise`.
struct Lattices
{
  explicit Lattices(double noise, bool turned = false)
    : Ids(10 * Parents)
  {
    std::iota(this->Ids.begin(), this->Ids.end(), 0);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> move(-noise, noise);
    const double corners[4][3] = { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. } };
    for (int p = 0; p < Parents; ++p)
    {
      for (int k = 0; k < 10; ++k)
      {
        const int a = k < 4 ? k : tetrahedron::EdgeVertices[k - 4][0];
        const int b = k < 4 ? k : tetrahedron::EdgeVertices[k - 4][1];
        for (int c = 0; c < 3; ++c)
        {
          const double middle = (corners[a][c] + corners[b][c]) / 2. + move(random);
          this->Points.push_back(turned ? -middle : middle);
        }
      }
    }
  }
  int GetSign() const { return GetSignOfChildren<Parents>(this->Ids.data(), this->Points.data()); }
  /// How many children have this orientation.
  int Count(int orientation) const
  {
    int count = 0;
    for (int p = 0; p < Parents; ++p)
    {
      for (const auto& child : tetrahedron::Children)
      {
        const double* corners[4];
        for (int k = 0; k < 4; ++k)
        {
          corners[k] = this->Points.data() + 3 * this->Ids[10 * p + child[k]];
        }
        count += GetOrientationOfTet(corners) == orientation ? 1 : 0;
      }
    }
    return count;
  }

  std::vector<int> Ids;
  std::vector<double> Points;
};

}

TEST(SignOfChildren, IsThatOfEachChild)
{
  for (const bool turned : { false, true })
  {
    const Lattices lattices(0.05, turned);
    EXPECT_EQ(lattices.GetSign(), turned ? -1 : 1);
    EXPECT_EQ(lattices.Count(turned ? -1 : 1), 8 * Parents);
    const std::vector<float> single(lattices.Points.begin(), lattices.Points.end());
    EXPECT_EQ(GetSignOfChildren<Parents>(lattices.Ids.data(), StoredPoints(single.data())),
      turned ? -1 : 1);
  }
}

TEST(SignOfChildren, OneChildOfManyIsSeen)
{
  const Lattices even(0.);
  for (int point = 0; point < 10 * Parents; ++point)
  {
    // Moved far through the middle of the parent, a point turns a child over.
    Lattices moved = even;
    const int parent = point / 10;
    for (int c = 0; c < 3; ++c)
    {
      double middle = 0.;
      for (int k = 0; k < 4; ++k)
      {
        middle += even.Points[3 * (10 * parent + k) + c] / 4.;
      }
      moved.Points[3 * point + c] += 3. * (middle - moved.Points[3 * point + c]);
    }
    EXPECT_GT(moved.Count(-1), 0) << point;
    EXPECT_EQ(moved.GetSign(), 0) << point;
  }
}

TEST(SignOfChildren, IsNotKnownWithoutNumbers)
{
  EXPECT_EQ(GetSignOfChildren<Parents>(Lattices(0.).Ids.data(), StoredPoints()), 0);
  for (const double value : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), 1e200, -1e200 })
  {
    for (int point = 0; point < 10 * Parents; ++point)
    {
      Lattices lattices(0.);
      lattices.Points[3 * point + 1] = value;
      const int sign = lattices.GetSign();
      EXPECT_TRUE(sign == 0 || lattices.Count(-sign) == 0) << value << " at " << point;
    }
  }
}
