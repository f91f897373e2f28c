// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MapSamples.h
 * Whether a characteristic map of a surface is regular and injective, at samples.
 */
#ifndef SubdivisionObjects_MapSamples_h
#define SubdivisionObjects_MapSamples_h

#include "Core/Smoothness/SmoothnessFacts.h"

#include <array>
#include <vector>

namespace subdivision
{

using MapPlace = std::array<double, 2>;

/// Twice the signed area of the triangle of three places.
double FindTriangleArea(const std::vector<MapPlace>& at, const std::array<int, 3>& ids);

/**
 * Sets Regular, Injective and Samples. The map is regular if all triangles, which turn around one
 * way before, do so on it; it is injective too if `ring`, a polygon around the middle, turns around
 * the origin in one direction and goes around once or, if it is `isOpen`, less than once.
 */
void SetSamples(const std::vector<MapPlace>& map, const std::vector<std::array<int, 3>>& triangles,
  const std::vector<int>& ring, bool isOpen, SmoothnessFacts& facts);

}

#endif
