// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/MapSamples.h"

#include "Core/Rules/Pi.h"

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>

namespace subdivision
{
namespace
{

bool KeepsOrientation(
  const std::vector<MapPlace>& map, const std::vector<std::array<int, 3>>& triangles)
{
  int positive = 0;
  for (const std::array<int, 3>& triangle : triangles)
  {
    positive += FindTriangleArea(map, triangle) > 0. ? 1 : -1;
  }
  // A map that turns the plane over is as good.
  return !triangles.empty() && std::abs(positive) == static_cast<int>(triangles.size());
}

bool GoesOnce(const std::vector<MapPlace>& map, const std::vector<int>& ring, bool isOpen)
{
  double sum = 0.;
  int positive = 0;
  const std::size_t sides = ring.size() - (isOpen ? 1 : 0);
  for (std::size_t i = 0; i < sides; ++i)
  {
    const MapPlace& a = map[ring[i]];
    const MapPlace& b = map[ring[(i + 1) % ring.size()]];
    const double turn =
      std::arg(std::complex<double>(b[0], b[1]) / std::complex<double>(a[0], a[1]));
    sum += turn;
    positive += turn > 0. ? 1 : -1;
  }
  const bool isOneWay = std::abs(positive) == static_cast<int>(sides);
  return isOneWay && (isOpen ? std::abs(sum) < 2. * Pi : std::abs(std::abs(sum) - 2. * Pi) < 1e-6);
}

}

double FindTriangleArea(const std::vector<MapPlace>& at, const std::array<int, 3>& ids)
{
  const MapPlace& a = at[ids[0]];
  const MapPlace& b = at[ids[1]];
  const MapPlace& c = at[ids[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

void SetSamples(const std::vector<MapPlace>& map, const std::vector<std::array<int, 3>>& triangles,
  const std::vector<int>& ring, bool isOpen, SmoothnessFacts& facts)
{
  facts.Samples = static_cast<int>(triangles.size());
  const bool isRegular = KeepsOrientation(map, triangles);
  facts.Regular = isRegular ? Answer::Yes : Answer::No;
  facts.Injective = isRegular && GoesOnce(map, ring, isOpen) ? Answer::Yes : Answer::No;
}

}
