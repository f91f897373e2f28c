// SPDX-License-Identifier: BSD-3-Clause
// Which maps are regular and injective.
#include "Precompiled.h"

#include "Core/Rules/Pi.h"
#include "Core/Smoothness/MapSamples.h"

using namespace subdivision;

namespace
{

/// Sides of a ring between two circles, of which all `all` would go around the origin `times`.
SmoothnessFacts Map(double times, int all, int sectors, double outer, double inner = 1.)
{
  std::vector<MapPlace> map;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> ring;
  const bool isOpen = sectors < all;
  for (int i = 0; i < sectors + (isOpen ? 1 : 0); ++i)
  {
    const double angle = 2. * Pi * times * i / all;
    for (const double radius : { inner, outer })
    {
      map.push_back({ { radius * std::cos(angle), radius * std::sin(angle) } });
    }
    ring.push_back(2 * i + 1);
  }
  for (int i = 0; i < sectors; ++i)
  {
    const int next = 2 * ((i + 1) % static_cast<int>(ring.size()));
    triangles.push_back({ { 2 * i, 2 * i + 1, next + 1 } });
    triangles.push_back({ { 2 * i, next + 1, next } });
  }
  SmoothnessFacts facts;
  SetSamples(map, triangles, ring, isOpen, facts);
  EXPECT_EQ(facts.Samples, 2 * sectors);
  return facts;
}

}

TEST(MapSamples, ARingIsRegularAndInjective)
{
  for (const double times : { 1., -1. }) // turned over it is as good
  {
    EXPECT_EQ(Map(times, 12, 12, 2.).Regular, Answer::Yes);
    EXPECT_EQ(Map(times, 12, 12, 2.).Injective, Answer::Yes);
  }
}

TEST(MapSamples, ARingThatGoesAroundTwiceIsNotInjective)
{
  EXPECT_EQ(Map(2., 12, 12, 2.).Regular, Answer::Yes);
  EXPECT_EQ(Map(2., 12, 12, 2.).Injective, Answer::No);
}

TEST(MapSamples, ASectorGoesLessThanOnceAround)
{
  EXPECT_EQ(Map(1., 12, 11, 2.).Injective, Answer::Yes);
  EXPECT_EQ(Map(1.2, 12, 11, 2.).Regular, Answer::Yes);
  EXPECT_EQ(Map(1.2, 12, 11, 2.).Injective, Answer::No);
}

TEST(MapSamples, WhatFoldsIsNeither)
{
  std::vector<MapPlace> map{ { { 0., 0. } }, { { 1., 0. } }, { { 1., 1. } }, { { 0.9, 0.1 } } };
  SmoothnessFacts facts;
  SetSamples(map, { { { 0, 1, 2 } }, { { 0, 2, 3 } } }, { 0, 1, 2, 3 }, false, facts);
  EXPECT_EQ(facts.Regular, Answer::No);
  EXPECT_EQ(facts.Injective, Answer::No);
  map[3] = { { std::nan(""), 0. } };
  SetSamples(map, { { { 0, 1, 2 } }, { { 0, 2, 3 } } }, { 0, 1, 2, 3 }, false, facts);
  EXPECT_EQ(facts.Regular, Answer::No);
}
