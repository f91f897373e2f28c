// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/StarMap.h"

#include "Core/Memory/Vectors.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

using Point = StarMap::Point;
using vectors::Cross;
using vectors::Dot;

Point Subtract(const Point& a, const Point& b, double factor = 1.)
{
  return { { a[0] - factor * b[0], a[1] - factor * b[1], a[2] - factor * b[2] } };
}

Point Scale(const Point& a, double factor)
{
  return { { factor * a[0], factor * a[1], factor * a[2] } };
}

Point Normalise(const Point& a)
{
  const double length = std::sqrt(Dot(a, a));
  return length > 0. ? Scale(a, 1. / length) : a;
}

/// Some direction across another one.
Point FindAcross(const Point& a)
{
  return Normalise(
    std::abs(a[0]) < 0.9 ? Cross(a, { { 1., 0., 0. } }) : Cross(a, { { 0., 1., 0. } }));
}

}

bool StarMapMaker::IsKnown(int point) const
{
  const Point& at = this->Points[point];
  return std::isfinite(at[0] + at[1] + at[2]);
}

void StarMapMaker::AddCell(const int* corners, int count, double size)
{
  if (std::all_of(corners, corners + count, [this](int point) { return this->IsKnown(point); }))
  {
    this->Corners.insert(this->Corners.end(), corners, corners + count);
    this->Ends.push_back(static_cast<int>(this->Corners.size()));
    this->Sizes.push_back(size);
  }
}

void StarMapMaker::Apply(const std::array<Point, 3>& rows, std::vector<Point>& points) const
{
  for (Point& point : points)
  {
    point = { { Dot(rows[0], point), Dot(rows[1], point), Dot(rows[2], point) } };
  }
}

void StarMapMaker::Straighten(int middle, int first, int second, std::vector<Point>& points) const
{
  const Point origin = points[middle];
  for (Point& point : points)
  {
    point = Subtract(point, origin);
  }
  // The inverse of the Cholesky factor of the moments makes them equal.
  std::array<Point, 3> moments{ { { { 0., 0., 0. } }, { { 0., 0., 0. } }, { { 0., 0., 0. } } } };
  for (const int corner : this->Corners)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        moments[i][j] += points[corner][i] * points[corner][j];
      }
    }
  }
  std::array<Point, 3> inverse{ { { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { 0., 0., 1. } } } };
  for (int i = 0; i < this->Dimension; ++i) // as Gram and Schmidt do
  {
    Point row{ { 0., 0., 0. } };
    row[i] = 1.;
    const auto multiply = [&](const Point& a, const Point& b)
    { return Dot(a, { { Dot(moments[0], b), Dot(moments[1], b), Dot(moments[2], b) } }); };
    for (int j = 0; j < i; ++j)
    {
      row = Subtract(row, inverse[j], multiply(row, inverse[j]));
    }
    inverse[i] = Scale(row, 1. / std::sqrt(multiply(row, row)));
  }
  this->Apply(inverse, points);
  // Moments are 1 now. A first point in the middle but for rounding has no direction and no length.
  const double length = std::sqrt(Dot(points[first], points[first]));
  const bool collapses = length < 1e-9;
  const Point x = collapses ? Point{ { 1., 0., 0. } } : Normalise(points[first]);
  Point y = Subtract(points[second], x, Dot(points[second], x));
  y = Dot(y, y) > 1e-12 * Dot(points[second], points[second]) ? Normalise(y) : FindAcross(x);
  Point z = Cross(x, y);
  if (this->Dimension == 2)
  {
    z = { { 0., 0., 1. } };
    y = Cross(z, x);
  }
  const double factor = collapses ? 1. : this->Rings[first] / length;
  this->Apply({ { Scale(x, factor), Scale(y, factor), Scale(z, factor) } }, points);
}

/// The signed area of a polygon, or volume of a tetrahedron.
double StarMapMaker::FindSize(const std::vector<Point>& points, std::size_t cell) const
{
  const int begin = cell == 0 ? 0 : this->Ends[cell - 1];
  const auto at = [&](int i) -> const Point& { return points[this->Corners[begin + i]]; };
  if (this->Dimension == 3)
  {
    return Dot(Subtract(at(1), at(0)), Cross(Subtract(at(2), at(0)), Subtract(at(3), at(0)))) / 6.;
  }
  double sum = 0.;
  for (int i = 1; begin + i + 1 < this->Ends[cell]; ++i)
  {
    sum += Cross(Subtract(at(i), at(0)), Subtract(at(i + 1), at(0)))[2] / 2.;
  }
  return sum;
}

StarMap StarMapMaker::Make(int middle, int first, int second) const
{
  StarMap map;
  map.Dimension = this->Dimension;
  std::vector<Point> points = this->Points;
  this->Straighten(middle, first, second, points);
  const auto findJacobians = [&]
  {
    int positive = 0;
    map.Jacobians.clear();
    for (std::size_t cell = 0; cell < this->Ends.size(); ++cell)
    {
      map.Jacobians.push_back(this->FindSize(points, cell) / this->Sizes[cell]);
      positive += map.Jacobians.back() > 0. ? 1 : -1;
    }
    return positive;
  };
  if (findJacobians() < 0)
  {
    const double y = this->Dimension == 2 ? -1. : 1.;
    const double z = this->Dimension == 2 ? 1. : -1.;
    this->Apply({ { { { 1., 0., 0. } }, { { 0., y, 0. } }, { { 0., 0., z } } } }, points);
    findJacobians();
  }
  std::vector<int> numbers(points.size(), -1);
  for (const int corner : this->Corners)
  {
    if (numbers[corner] < 0)
    {
      numbers[corner] = static_cast<int>(map.Points.size());
      map.Points.push_back(points[corner]);
      map.Rings.push_back(this->Rings[corner]);
    }
    map.Corners.push_back(numbers[corner]);
  }
  map.Ends = this->Ends;
  return map;
}

}
