// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Samples/PieceSamples.h"

#include "Core/Memory/Vectors.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

using namespace vectors;

namespace
{

/// The corners at the ends of edges, in the order of the middles.
constexpr int Ends[6][2] = { { 0, 1 }, { 0, 2 }, { 1, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };

}

int SampleGrid::GetFirst(int axis, double place) const
{
  const double index = std::ceil((place - this->Origin[axis]) / this->Spacing[axis] - 1e-6);
  return index > this->Extent[2 * axis]
    ? static_cast<int>(std::min(index, this->Extent[2 * axis + 1] + 1.))
    : this->Extent[2 * axis];
}

int SampleGrid::GetLast(int axis, double place) const
{
  const double index = std::floor((place - this->Origin[axis]) / this->Spacing[axis] + 1e-6);
  return index < this->Extent[2 * axis + 1]
    ? static_cast<int>(std::max(index, this->Extent[2 * axis] - 1.))
    : this->Extent[2 * axis + 1];
}

std::array<double, 10> GetShares(const Place& w)
{
  const double first = 1. - w[0] - w[1] - w[2];
  return { first * (2. * first - 1.), w[0] * (2. * w[0] - 1.), w[1] * (2. * w[1] - 1.),
    w[2] * (2. * w[2] - 1.), 4. * first * w[0], 4. * first * w[1], 4. * w[0] * w[1],
    4. * first * w[2], 4. * w[0] * w[2], 4. * w[1] * w[2] };
}

TetrahedronSamples::TetrahedronSamples(const std::array<Place, 10>& absolute)
  : Origin(absolute[0])
{
  std::array<Place, 10> nodes = absolute;
  for (Place& node : nodes)
  {
    node = Subtract(node, this->Origin);
  }
  std::array<Place, 10> control = nodes;
  for (int e = 0; e < 6; ++e)
  {
    for (int x = 0; x < 3; ++x)
    {
      control[4 + e][x] = 2. * nodes[4 + e][x] - (nodes[Ends[e][0]][x] + nodes[Ends[e][1]][x]) / 2.;
    }
  }
  this->Low = this->High = control[0];
  for (const Place& point : control)
  {
    for (int x = 0; x < 3; ++x)
    {
      this->Low[x] = std::min(this->Low[x], point[x]);
      this->High[x] = std::max(this->High[x], point[x]);
    }
  }
  for (int x = 0; x < 3; ++x)
  {
    this->Low[x] += this->Origin[x];
    this->High[x] += this->Origin[x];
  }
  for (int x = 0; x < 3; ++x)
  {
    const auto at = [&](int c) { return control[c][x]; };
    const double a = at(0);
    this->Powers[0][x] = a;
    this->Powers[1][x] = 2. * (at(4) - a);
    this->Powers[2][x] = 2. * (at(5) - a);
    this->Powers[3][x] = 2. * (at(7) - a);
    this->Powers[4][x] = a + at(1) - 2. * at(4);
    this->Powers[5][x] = a + at(2) - 2. * at(5);
    this->Powers[6][x] = a + at(3) - 2. * at(7);
    this->Powers[7][x] = 2. * (a + at(6) - at(4) - at(5));
    this->Powers[8][x] = 2. * (a + at(8) - at(4) - at(7));
    this->Powers[9][x] = 2. * (a + at(9) - at(5) - at(7));
  }
  const Place edges[3] = { nodes[1], nodes[2], nodes[3] };
  const Place normals[3] = { Cross(edges[1], edges[2]), Cross(edges[2], edges[0]),
    Cross(edges[0], edges[1]) };
  const double volume = Dot(edges[0], normals[0]);
  const double size = std::sqrt(Dot(edges[0], edges[0]) * Dot(normals[0], normals[0]));
  this->IsFlat = !(std::abs(volume) > 1e-12 * size);
  if (this->IsFlat)
  {
    return;
  }
  this->Planes[0] = { 0., 0., 0., 1. };
  for (int c = 0; c < 3; ++c)
  {
    for (int x = 0; x < 3; ++x)
    {
      this->Planes[c + 1][x] = normals[c][x] / volume;
      this->Planes[0][x] -= this->Planes[c + 1][x];
    }
  }
  for (int c = 0; c < 4; ++c)
  {
    const auto& plane = this->Planes[c];
    double least = 0.;
    for (int e = 4; e < 10; ++e)
    {
      const Place& p = control[e];
      least = std::min(least, plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3]);
    }
    this->Least[c] = least - 1e-6;
  }
}

Place TetrahedronSamples::Evaluate(const Place& w) const
{
  Place at{};
  const auto& p = this->Powers;
  for (int x = 0; x < 3; ++x)
  {
    at[x] = p[0][x] + w[0] * (p[1][x] + w[0] * p[4][x] + w[1] * p[7][x] + w[2] * p[8][x]) +
      w[1] * (p[2][x] + w[1] * p[5][x] + w[2] * p[9][x]) + w[2] * (p[3][x] + w[2] * p[6][x]);
  }
  return at;
}

bool TetrahedronSamples::Clip(double y, double z, double& low, double& high) const
{
  low -= this->Origin[0];
  high -= this->Origin[0];
  for (int c = 0; c < 4 && !this->IsFlat; ++c)
  {
    const auto& plane = this->Planes[c];
    // plane[0] x >= bound
    const double bound = this->Least[c] - plane[1] * (y - this->Origin[1]) -
      plane[2] * (z - this->Origin[2]) - plane[3];
    if (plane[0] > 0.)
    {
      low = std::max(low, bound / plane[0]);
    }
    else if (plane[0] < 0.)
    {
      high = std::min(high, bound / plane[0]);
    }
    else if (bound > 0.)
    {
      return false;
    }
  }
  const bool isThere = low <= high;
  low += this->Origin[0];
  high += this->Origin[0];
  return isThere;
}

bool TetrahedronSamples::MayReach(const Place& middle, const Place& half) const
{
  bool mayReach = true;
  for (int c = 0; c < 4 && !this->IsFlat; ++c)
  {
    const auto& plane = this->Planes[c];
    double most = plane[3];
    for (int x = 0; x < 3; ++x)
    {
      most += plane[x] * (middle[x] - this->Origin[x]) + std::abs(plane[x]) * half[x];
    }
    mayReach = mayReach && most >= this->Least[c];
  }
  return mayReach;
}

Place TetrahedronSamples::GetStraightWeights(const Place& p) const
{
  if (this->IsFlat)
  {
    return { 0.25, 0.25, 0.25 };
  }
  Place weights{};
  for (int c = 0; c < 3; ++c)
  {
    const auto& plane = this->Planes[c + 1];
    weights[c] = plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
  }
  return weights;
}

bool TetrahedronSamples::Find(const Place& absolute, bool isNear, Place& weights) const
{
  const Place place = Subtract(absolute, this->Origin);
  if (isNear && this->Iterate(place, weights) && IsInside(weights))
  {
    return true;
  }
  weights = this->GetStraightWeights(place);
  if (this->Iterate(place, weights) && IsInside(weights))
  {
    return true;
  }
  return false;
}

bool TetrahedronSamples::Iterate(const Place& place, Place& w) const
{
  const auto& p = this->Powers;
  for (int round = 0; round < 12; ++round)
  {
    const Place rest = Subtract(place, this->Evaluate(w));
    Place slopes[3];
    for (int x = 0; x < 3; ++x)
    {
      slopes[0][x] = p[1][x] + 2. * w[0] * p[4][x] + w[1] * p[7][x] + w[2] * p[8][x];
      slopes[1][x] = p[2][x] + 2. * w[1] * p[5][x] + w[0] * p[7][x] + w[2] * p[9][x];
      slopes[2][x] = p[3][x] + 2. * w[2] * p[6][x] + w[0] * p[8][x] + w[1] * p[9][x];
    }
    const Place cross[3] = { Cross(slopes[1], slopes[2]), Cross(slopes[2], slopes[0]),
      Cross(slopes[0], slopes[1]) };
    const double determinant = Dot(slopes[0], cross[0]);
    if (determinant == 0.)
    {
      return false;
    }
    double most = 0.;
    for (int c = 0; c < 3; ++c)
    {
      const double step = Dot(rest, cross[c]) / determinant;
      w[c] += step;
      most = std::max(most, std::abs(step));
    }
    if (!(most < 4.)) // it runs away, or is NaN
    {
      return false;
    }
    if (most < 1e-7) // the error is its square
    {
      return true;
    }
  }
  return false;
}

namespace
{

NearestPoint FindNearestOfLine(const Place& a, const Place& b, const Place& place)
{
  const Place along = Subtract(b, a);
  const double length = Dot(along, along);
  const double part =
    length > 0. ? std::min(std::max(Dot(Subtract(place, a), along) / length, 0.), 1.) : 0.;
  const Place rest = { place[0] - a[0] - part * along[0], place[1] - a[1] - part * along[1],
    place[2] - a[2] - part * along[2] };
  return { { 1. - part, part, 0. }, Dot(rest, rest) };
}

}

NearestPoint FindNearest(const Place* corners, int size, const Place& place)
{
  if (size == 1)
  {
    const Place rest = Subtract(place, corners[0]);
    return { { 1., 0., 0. }, Dot(rest, rest) };
  }
  if (size == 2)
  {
    return FindNearestOfLine(corners[0], corners[1], place);
  }
  const Place a = Subtract(corners[1], corners[0]);
  const Place b = Subtract(corners[2], corners[0]);
  const Place rest = Subtract(place, corners[0]);
  const Place normal = Cross(a, b);
  const double area = Dot(normal, normal);
  if (area > 0.)
  {
    const double u = Dot(Cross(rest, b), normal) / area;
    const double v = Dot(Cross(a, rest), normal) / area;
    if (u >= 0. && v >= 0. && u + v <= 1.)
    {
      const double height = Dot(rest, normal);
      return { { 1. - u - v, u, v }, height * height / area };
    }
  }
  NearestPoint nearest = FindNearestOfLine(corners[0], corners[1], place);
  for (const int c : { 1, 2 })
  {
    const int next = (c + 1) % 3;
    const NearestPoint other = FindNearestOfLine(corners[c], corners[next], place);
    if (other.Square < nearest.Square)
    {
      nearest = { {}, other.Square };
      nearest.Weights[c] = other.Weights[0];
      nearest.Weights[next] = other.Weights[1];
    }
  }
  return nearest;
}

}
