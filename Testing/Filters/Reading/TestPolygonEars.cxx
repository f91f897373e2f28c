// SPDX-License-Identifier: BSD-3-Clause
#include "Precompiled.h"

#include "Private/Reading/PolygonEars.h"

using subdivision::PointOrder;
using subdivision::PolygonEars;

namespace
{

using Place = std::array<double, 2>;
using Triangles = std::vector<std::array<vtkIdType, 3>>;

/// A polygon, and which point is at each of its corners; several may have the same one.
struct Loop
{
  std::vector<Place> Places;
  std::vector<vtkIdType> Ids;
};

Triangles Cut(const Loop& loop, int type)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (const Place& place : loop.Places)
  {
    points->InsertNextPoint(place[0], 0.5 * place[0] - 2. * place[1] + 7., place[1]);
  }
  PolygonEars ears(points, PointOrder());
  return ears.Cut(loop.Ids.data(), static_cast<vtkIdType>(loop.Ids.size()));
}

double FindArea(const Place& a, const Place& b, const Place& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// In any order of points.
Loop Number(const std::vector<Place>& outline, std::mt19937& random)
{
  Loop loop;
  loop.Ids.resize(outline.size());
  std::iota(loop.Ids.begin(), loop.Ids.end(), 0);
  std::shuffle(loop.Ids.begin(), loop.Ids.end(), random);
  loop.Places.resize(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    loop.Places[loop.Ids[i]] = outline[i];
  }
  return loop;
}

using Shape = std::vector<Place> (*)(int n, std::mt19937& random);

double Draw(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Place OnCircle(double radius, double turns)
{
  const double angle = 2. * 3.141592653589793 * turns;
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

std::vector<Place> MakeCircle(int n, std::mt19937&)
{
  std::vector<Place> outline;
  for (int i = 0; i < n; ++i)
  {
    outline.push_back(OnCircle(1., double(i) / n));
  }
  return outline;
}

std::vector<Place> MakeStar(int n, std::mt19937& random)
{
  std::vector<Place> outline;
  for (int i = 0; i < n; ++i)
  {
    outline.push_back(OnCircle(Draw(random, 0.1, 1.), double(i) / n));
  }
  return outline;
}

/// Long teeth, turned: their boxes hold most other corners.
std::vector<Place> MakeComb(int n, std::mt19937&)
{
  std::vector<Place> outline = { { 0., 0. }, { 8., 8. } };
  const double step = 16. / n;
  for (double at = 8.; at > step; at -= step)
  {
    outline.push_back({ at - 5., at + 5. });
    outline.push_back({ at - 0.5 * step - 0.01, at - 0.5 * step + 0.01 });
  }
  return outline;
}

/// Many corners on straight lines, many equal lengths, and many places twice; it crosses itself.
std::vector<Place> MakeWalkOnAGrid(int n, std::mt19937& random)
{
  std::vector<Place> outline;
  Place at = { 0., 0. };
  for (int i = 0; i < n; ++i)
  {
    at[random() % 2] += random() % 3 == 0 ? -1. : 1.;
    outline.push_back(at);
  }
  return outline;
}

std::vector<Place> MakeNoise(int n, std::mt19937& random)
{
  std::vector<Place> outline;
  for (int i = 0; i < n; ++i)
  {
    outline.push_back({ Draw(random, 0., 1.), Draw(random, 0., 1.) });
  }
  return outline;
}

/// Bends that are as small as what counts as zero.
std::vector<Place> MakeAlmostStraight(int n, std::mt19937& random)
{
  std::vector<Place> outline = { { 0.5, -1. } };
  for (int i = 0; i < n; ++i)
  {
    outline.push_back({ 1. - double(i) / n, Draw(random, 0., 1e-10) });
  }
  return outline;
}

std::vector<Place> MakeSpiral(int n, std::mt19937&)
{
  std::vector<Place> outline;
  for (int side = 0; side < 2; ++side)
  {
    for (int i = 0; i < n / 2; ++i)
    {
      const int at = side == 0 ? i : n / 2 - 1 - i;
      outline.push_back(OnCircle(1. + 10. * at / n + 0.4 * side, 5. * at / n));
    }
  }
  return outline;
}

/// A ring with a bridge: two sides at one place.
std::vector<Place> MakeRing(int n, std::mt19937&)
{
  std::vector<Place> outline;
  const int half = n / 2 - 1;
  for (int i = 0; i <= half; ++i)
  {
    outline.push_back(OnCircle(1., double(i) / half));
  }
  for (int i = half; i >= 0; --i)
  {
    outline.push_back(OnCircle(0.5, double(i) / half));
  }
  return outline;
}

/// Many corners on straight lines.
std::vector<Place> MakeSquare(int n, std::mt19937&)
{
  std::vector<Place> outline;
  const int ofSide = n / 4;
  for (int i = 0; i < 4 * ofSide; ++i)
  {
    const double at = double(i % ofSide) / ofSide;
    const Place sides[] = { { at, 0. }, { 1., at }, { 1. - at, 1. }, { 0., 1. - at } };
    outline.push_back(sides[i / ofSide]);
  }
  return outline;
}

}

// More than MostCorners are cut by VTK.
TEST(PolygonEars, TrianglesFillAPolygonOfAnySize)
{
  std::mt19937 random(3);
  int number = 0;
  for (const Shape shape : { MakeCircle, MakeStar, MakeComb, MakeSpiral, MakeSquare, MakeRing })
  {
    SCOPED_TRACE("shape " + std::to_string(number++));
    for (const int n : { 40, 400, 2000, 2001, 4000 })
    {
      SCOPED_TRACE(n);
      const Loop loop = Number(shape(n, random), random);
      for (const int type : { VTK_FLOAT, VTK_DOUBLE })
      {
        const Triangles triangles = Cut(loop, type);
        ASSERT_EQ(triangles.size() + 2, loop.Ids.size());
        double whole = 0.;
        for (std::size_t i = 0; i < loop.Ids.size(); ++i)
        {
          const Place& a = loop.Places[loop.Ids[i]];
          const Place& b = loop.Places[loop.Ids[(i + 1) % loop.Ids.size()]];
          whole += a[0] * b[1] - a[1] * b[0];
        }
        double sum = 0.; // of areas on the side of the polygon
        for (const auto& t : triangles)
        {
          const double area = FindArea(loop.Places[t[0]], loop.Places[t[1]], loop.Places[t[2]]);
          sum += std::max(whole > 0. ? area : -area, 0.);
        }
        EXPECT_NEAR(sum, std::abs(whole), 1e-6 * std::abs(whole));
      }
    }
  }
}

// VTK refuses some of them.
TEST(PolygonEars, WhatCrossesItselfHasAsManyTriangles)
{
  std::mt19937 random(1);
  int number = 0;
  for (const Shape shape : { MakeWalkOnAGrid, MakeNoise, MakeAlmostStraight })
  {
    SCOPED_TRACE("shape " + std::to_string(number++));
    for (const int n : { 5, 40, 400, 2400 })
    {
      const Loop loop = Number(shape(n, random), random);
      const Triangles triangles = Cut(loop, VTK_DOUBLE);
      EXPECT_EQ(triangles.size() + 2, loop.Ids.size()) << n;
      std::vector<char> isUsed(loop.Ids.size(), 0);
      for (const auto& triangle : triangles)
      {
        for (const vtkIdType id : triangle)
        {
          isUsed[id] = 1;
        }
      }
      EXPECT_EQ(std::count(isUsed.begin(), isUsed.end(), 0), 0) << n;
    }
  }
}
