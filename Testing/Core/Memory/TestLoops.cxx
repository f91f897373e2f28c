// SPDX-License-Identifier: BSD-3-Clause
// Loops: every element once, and BetweenLoops acts within long ones, where it may end them.
#include "Core/Memory/Loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

using namespace subdivision;

namespace
{

/// The work of some hundred nanoseconds.
double Work(vtkIdType i)
{
  volatile double value = static_cast<double>(i);
  for (int k = 0; k < 200; ++k)
  {
    value = value * 0.999 + 1.;
  }
  return value;
}

}

TEST(Loops, ReachEachElementOnceInAnyParts)
{
  const BetweenLoops between([] {});
  for (const vtkIdType size : { 0, 1, 8192, 8193, 65536, 65537, 3000001 })
  {
    std::vector<unsigned char> times(static_cast<std::size_t>(size), 0);
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          ++times[i];
        }
      });
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), size);
    std::vector<unsigned char> blocks(static_cast<std::size_t>(size), 0);
    ForRangesOfBlocks(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          ++blocks[i];
        }
      });
    EXPECT_EQ(std::count(blocks.begin(), blocks.end(), 1), size);
  }
}

TEST(Loops, LongOnesActInBetween)
{
  const double seconds = BetweenLoops::SecondsBetween;
  BetweenLoops::SecondsBetween = 0.;
  int acts = 0;
  {
    const BetweenLoops between([&acts] { ++acts; });
    std::atomic<double> last{ 0. };
    ForEach(2000000, [&](vtkIdType i) { last = Work(i); });
    EXPECT_GT(acts, 3) << "half a second or more of work in parts of 0.05 s";
    acts = 0;
    ForEachInTurn(10 * BetweenLoops::TurnsBetween + 1, [](vtkIdType) {});
    EXPECT_EQ(acts, 10);
  }
  ForEachInTurn(10 * BetweenLoops::TurnsBetween, [](vtkIdType) {});
  EXPECT_EQ(acts, 10) << "it lives no more";
  BetweenLoops::SecondsBetween = seconds;
}

TEST(Loops, EndWhereTheActThrows)
{
  const double seconds = BetweenLoops::SecondsBetween;
  BetweenLoops::SecondsBetween = 0.;
  {
    const BetweenLoops between([] { throw std::runtime_error("stop"); });
    vtkIdType turns = 0;
    EXPECT_THROW(ForEachInTurn(1000000, [&](vtkIdType i) { turns = i + 1; }), std::runtime_error);
    EXPECT_EQ(turns, BetweenLoops::TurnsBetween);
    std::atomic<vtkIdType> done{ 0 };
    EXPECT_THROW(
      ForEach(10000000, [&](vtkIdType i) { done += Work(i) > 0. ? 1 : 0; }), std::runtime_error);
    EXPECT_LT(done, 10000000);
  }
  BetweenLoops::SecondsBetween = seconds;
}
