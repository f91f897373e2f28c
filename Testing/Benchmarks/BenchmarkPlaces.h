// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkPlaces.h
 * The places of each cell at which limits are measured.
 */
#ifndef SubdivisionObjects_BenchmarkPlaces_h
#define SubdivisionObjects_BenchmarkPlaces_h

#include <array>
#include <cmath>

namespace benchmarks
{

constexpr int PlacesOfCell = 10;

/// The weights of the second and third corner: they are spread over the cell, and none is a vertex
/// of a level.
inline std::array<double, 2> GetPlace(int i)
{
  const double u = std::fmod(0.137 + 0.618033988749895 * i, 1.);
  const double v = std::fmod(0.291 + 0.754877666246693 * i, 1.);
  return { { 0.89 * u * (1. - v), 0.89 * u * v } };
}

}

#endif
