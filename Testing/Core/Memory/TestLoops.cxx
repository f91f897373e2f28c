// SPDX-License-Identifier: BSD-3-Clause
// Loops: every element once, and BetweenLoops acts within long ones, where it may end them.
#include "Precompiled.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/UnevenRanges.h"

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <thread>

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

/// As where memory is new from some element on: it takes far longer than that before.
TEST(Loops, PartsEndWhereElementsTakeFarLonger)
{
  const double seconds = BetweenLoops::SecondsBetween;
  BetweenLoops::SecondsBetween = 0.;
  constexpr vtkIdType easy = 1 << 20;
  constexpr vtkIdType size = 2 * easy;
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  std::atomic<vtkIdType> visited{ 0 };
  int acts = 0;
  {
    const BetweenLoops between([&] { acts += visited > easy ? 1 : 0; });
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        const vtkIdType hard = end - std::min(end, std::max(begin, easy));
        std::this_thread::sleep_for(threads * std::chrono::microseconds(hard));
        visited += end - begin;
      });
  }
  EXPECT_EQ(visited, size);
  EXPECT_GE(acts, 5) << "a second of work in parts of 0.05 s";
  BetweenLoops::SecondsBetween = seconds;
}

TEST(Loops, UnevenOnesVisitEachOnceAndActInBetween)
{
  const double seconds = BetweenLoops::SecondsBetween;
  BetweenLoops::SecondsBetween = 0.;
  for (const vtkIdType size : { 0, 1, 16, 33, 1000 })
  {
    std::vector<unsigned char> times(static_cast<std::size_t>(size), 0);
    subdivision::ForUnevenRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          ++times[i];
        }
      });
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), size);
  }
  int acts = 0;
  {
    const BetweenLoops between([&acts] { ++acts; });
    const auto sleep = [](vtkIdType, vtkIdType)
    { std::this_thread::sleep_for(std::chrono::milliseconds(60)); };
    const int ranges = 4 * vtkSMPTools::GetEstimatedNumberOfThreads();
    subdivision::ForUnevenRanges(16 * ranges, sleep);
    EXPECT_GE(acts, 4) << "each range takes longer than threads go on without a stop";
  }
  BetweenLoops::SecondsBetween = seconds;
}

/// As on a busy machine, where it takes longer to start threads.
TEST(Loops, UnevenOnesEndWhereThreadsBeginTooLate)
{
  const double seconds = BetweenLoops::SecondsBetween;
  const double ofRanges = subdivision::SecondsOfUnevenRanges;
  BetweenLoops::SecondsBetween = 0.;
  subdivision::SecondsOfUnevenRanges = -1.;
  std::atomic<int> visited{ 0 };
  {
    int acts = 0;
    const BetweenLoops between(
      [&acts]
      {
        if (++acts > 1000)
        {
          throw std::runtime_error("the loop does not go on");
        }
      });
    EXPECT_NO_THROW(subdivision::ForUnevenRanges(
      160, [&](vtkIdType begin, vtkIdType end) { visited += static_cast<int>(end - begin); }));
  }
  EXPECT_EQ(visited, 160);
  subdivision::SecondsOfUnevenRanges = ofRanges;
  BetweenLoops::SecondsBetween = seconds;
}

/// Where each part takes long to start, parts do not become so small that the loop never ends.
TEST(Loops, PartsStayLargeWhereThreadsBeginTooLate)
{
  const double seconds = BetweenLoops::SecondsBetween;
  BetweenLoops::SecondsBetween = 0.;
  std::atomic<bool> begins{ true };
  std::atomic<vtkIdType> visited{ 0 };
  {
    int acts = 0;
    const BetweenLoops between(
      [&]
      {
        begins = true;
        if (++acts > 1100)
        {
          throw std::runtime_error("the loop does not go on");
        }
      });
    EXPECT_NO_THROW(ForRanges(1 << 20,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(begins.exchange(false) ? 30 : 0));
        visited += end - begin;
      }));
  }
  EXPECT_EQ(visited, 1 << 20);
  BetweenLoops::SecondsBetween = seconds;
}

TEST(Loops, InTurnIsALoopOfTheLanguageThatActs)
{
  const double seconds = BetweenLoops::SecondsBetween;
  BetweenLoops::SecondsBetween = 0.;
  int acts = 0;
  {
    const BetweenLoops between([&acts] { ++acts; });
    const int turns = BetweenLoops::TurnsBetween;
    vtkIdType sum = 0;
    for (const vtkIdType i : InTurn(static_cast<vtkIdType>(5) * turns))
    {
      sum += i % 2;
    }
    EXPECT_EQ(sum, 5 * turns / 2);
    EXPECT_EQ(acts, 5);
    acts = 0;
    std::vector<int> list(3 * turns + 7, 1);
    for (int& item : InTurn(list))
    {
      ++item;
    }
    EXPECT_EQ(std::count(list.begin(), list.end(), 2), 3 * turns + 7);
    EXPECT_EQ(acts, 3);
    for (const int negative : InTurn(-1))
    {
      ADD_FAILURE() << negative;
    }
    acts = 0;
    for (const int i : InTurn(10 * turns))
    {
      if (i == turns)
      {
        break;
      }
    }
    EXPECT_EQ(acts, 1);
  }
  BetweenLoops::SecondsBetween = seconds;
}

TEST(Loops, MemoryIsFilledAndCopiedInParts)
{
  const double seconds = BetweenLoops::SecondsBetween;
  BetweenLoops::SecondsBetween = 0.;
  int acts = 0;
  {
    const BetweenLoops between([&acts] { ++acts; });
    constexpr vtkIdType size = 1 << 22;
    const Buffer<int> filled(size, 3);
    EXPECT_GT(acts, 2);
    EXPECT_EQ(std::count(filled.begin(), filled.end(), 3), size);
    acts = 0;
    Buffer<long long> copy(size);
    CopyInThreads(filled.data(), size, copy.data());
    EXPECT_GT(acts, 2);
    EXPECT_EQ(std::count(copy.begin(), copy.end(), 3), size);
    acts = 0;
    const Rows<int> rows = ListByRow<int>(
      10, size, [](vtkIdType i) { return i % 7; }, [](vtkIdType i) { return static_cast<int>(i); });
    EXPECT_GT(acts, size / BetweenLoops::TurnsBetween);
    EXPECT_EQ(rows[8].size(), 0);
    const Row<int> third = rows[3];
    ASSERT_EQ(third.size(), size / 7);
    for (vtkIdType i = 0; i < third.size(); ++i)
    {
      ASSERT_EQ(third.begin()[i], 3 + 7 * i);
    }
  }
  BetweenLoops::SecondsBetween = seconds;
}

/// In a thread that is not this one an exception would end the program.
TEST(Loops, ThrowWhatABodyThrowsInAnyThread)
{
  const std::string before = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread")); // TBB passes exceptions on by itself
  vtkSMPTools::Initialize(4);
  const vtkIdType size = 1000000;
  const auto fail = [](vtkIdType, vtkIdType)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1)); // so that all threads take part
    throw std::bad_alloc();
  };
  EXPECT_THROW(ForRanges(size, fail), std::bad_alloc);
  const auto failElsewhere = [here = std::this_thread::get_id()](vtkIdType, vtkIdType)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (std::this_thread::get_id() != here)
    {
      throw std::bad_alloc();
    }
  };
  EXPECT_THROW(ForRanges(size, failElsewhere), std::bad_alloc);
  EXPECT_THROW(ForRangesOfBlocks(100, fail), std::bad_alloc);
  EXPECT_THROW(ForUnevenRanges(size, fail), std::bad_alloc);
  {
    const BetweenLoops between([] {});
    EXPECT_THROW(ForUnevenRanges(size, fail), std::bad_alloc);
  }
  std::atomic<vtkIdType> sum(0);
  ForRanges(size, [&](vtkIdType begin, vtkIdType end) { sum += end - begin; });
  EXPECT_EQ(sum, size);
  vtkSMPTools::SetBackend(before.c_str());
  vtkSMPTools::Initialize(0);
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
