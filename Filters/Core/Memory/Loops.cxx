// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Memory/Loops.h"

#include "Core/Memory/UnevenRanges.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <utility>

namespace subdivision
{
namespace
{

thread_local BetweenLoops* Current = nullptr;
thread_local int DepthOfLoops = 0; ///< of loops that several threads run

/// A body whose first exception goes on in the thread that began the loop: in another thread it
/// would end the program, for instance where memory ends. Ranges after it are left out.
class CaughtBody
{
public:
  explicit CaughtBody(const RangeBody& body)
    : Body(body)
  {
  }
  void operator()(vtkIdType begin, vtkIdType end)
  {
    if (this->IsFailed)
    {
      return;
    }
    try
    {
      this->Body(begin, end);
    }
    catch (...)
    {
      if (!this->IsFailed.exchange(true))
      {
        this->Failure = std::current_exception();
      }
    }
  }
  bool HasFailed() const { return this->IsFailed; }
  /// After the loop.
  void Throw() const
  {
    if (this->Failure)
    {
      std::rethrow_exception(this->Failure);
    }
  }

private:
  const RangeBody Body;
  std::atomic<bool> IsFailed{ false };
  std::exception_ptr Failure;
};

using Clock = std::chrono::steady_clock;

/// Each of several threads, of which this may be one, takes `atATime` elements after the other from
/// `begin` on, until it is time to act. Returns the first that none has taken.
vtkIdType RunForAWhile(vtkIdType begin, vtkIdType end, vtkIdType atATime, CaughtBody& body)
{
  const bool isEndless = !Current || DepthOfLoops > 0; // nobody would act
  const auto last = Clock::now() +
    std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(SecondsOfUnevenRanges));
  std::atomic<vtkIdType> next(begin);
  const auto take = [&](vtkIdType, vtkIdType)
  {
    do // once in any case: on a busy machine threads begin when the time is up
    {
      const vtkIdType first = next.fetch_add(atATime);
      if (first >= end)
      {
        return;
      }
      body(first, end - first > atATime ? first + atATime : end);
    } while (!body.HasFailed() && (isEndless || Clock::now() < last));
  };
  {
    struct Depth
    {
      Depth() { ++DepthOfLoops; }
      ~Depth() { --DepthOfLoops; }
    } const depth;
    vtkSMPTools::For(0, vtkSMPTools::GetEstimatedNumberOfThreads(), 1, take);
  }
  body.Throw();
  return std::min(next.load(), end);
}

/// How long a part takes that runs until this thread may act.
constexpr double SecondsOfParts = 0.02;

/// Runs the body in threads for parts of [begin, size), the first of which has `first` elements.
/// The next ones should take SecondsOfParts, by the time of the part before. A part that takes far
/// longer ends early: new memory of the system may be written a hundred times as slowly as the
/// memory before. Threads take `least` elements at a time, or more.
void RunInParts(
  vtkIdType begin, vtkIdType size, vtkIdType first, vtkIdType least, const RangeBody& body)
{
  constexpr double mostGrowth = 4.; // the next part may be harder work
  constexpr int portions = 32;      // of a thread in a part
  const vtkIdType takes = vtkIdType(portions) * vtkSMPTools::GetEstimatedNumberOfThreads();
  CaughtBody caught(body);
  vtkIdType most = Current ? first : size;
  while (begin < size)
  {
    const vtkIdType end = size - begin > most ? begin + most : size;
    const auto start = Clock::now();
    const vtkIdType reached =
      RunForAWhile(begin, end, std::max(least, (end - begin) / takes), caught);
    const std::chrono::duration<double> taken = Clock::now() - start;
    const double factor =
      taken.count() * mostGrowth > SecondsOfParts ? SecondsOfParts / taken.count() : mostGrowth;
    // Not fewer than at first: on a busy machine it may be the start of threads that took so long.
    most = std::max(first, static_cast<vtkIdType>(factor * static_cast<double>(reached - begin)));
    begin = reached;
    BetweenLoops::Act();
  }
}

/// Runs the body in this thread for the first elements, a few more each time, until the rest would
/// take longer than a start of threads (some 0.06 ms). Most loops over a level of some 10,000
/// elements end before. Returns how many elements that were, and sets the time of one, by the last
/// of them: the first ones may wait for memory.
vtkIdType RunAlone(vtkIdType size, const RangeBody& body, double& secondsOfOne)
{
  constexpr double worthThreads = 2e-4;
  constexpr vtkIdType fewest = 64;
  constexpr vtkIdType most = 1024;
  for (vtkIdType begin = 0; begin < size;)
  {
    const vtkIdType count = std::min(std::clamp(begin, fewest, most), size - begin);
    const auto start = Clock::now();
    body(begin, begin + count);
    const std::chrono::duration<double> taken = Clock::now() - start;
    const bool isFirst = begin == 0;
    begin += count;
    secondsOfOne = taken.count() / static_cast<double>(count);
    if (!isFirst && secondsOfOne * static_cast<double>(size - begin) > worthThreads)
    {
      return begin;
    }
  }
  return size;
}

}

BetweenLoops::BetweenLoops(std::function<void()> act)
  : Work(std::move(act))
  , Outer(Current)
  , Last(Clock::now())
{
  Current = this;
}

BetweenLoops::~BetweenLoops()
{
  Current = this->Outer;
}

void BetweenLoops::Act()
{
  if (!Current || DepthOfLoops > 0)
  {
    return;
  }
  const std::chrono::duration<double> since = Clock::now() - Current->Last;
  if (since.count() >= SecondsBetween)
  {
    Current->Work();
    Current->Last = Clock::now();
  }
}

void ForRanges(vtkIdType size, RangeBody body)
{
  constexpr vtkIdType inOnePart = 1 << 16;
  constexpr vtkIdType mostInOnePart = 1 << 18;
  constexpr vtkIdType atATime = 1024;
  if (size <= WorthThreads)
  {
    body(0, size);
    BetweenLoops::Act();
    return;
  }
  double secondsOfOne = 0.;
  const bool hasThreads = vtkSMPTools::GetEstimatedNumberOfThreads() > 1;
  const vtkIdType done = hasThreads ? RunAlone(size, body, secondsOfOne) : 0;
  const bool areEasy = secondsOfOne * static_cast<double>(mostInOnePart) < SecondsOfParts;
  RunInParts(done, size, hasThreads && areEasy ? mostInOnePart : inOnePart, atATime, body);
  if (done == size)
  {
    BetweenLoops::Act();
  }
}

void ForRangesOfBlocks(vtkIdType blocks, RangeBody body, vtkIdType worthThreads)
{
  constexpr vtkIdType inOnePart = 8;
  if (blocks < worthThreads)
  {
    body(0, blocks);
    BetweenLoops::Act();
    return;
  }
  RunInParts(0, blocks, std::max(inOnePart, worthThreads), 1, body);
}

void ForUnevenRanges(vtkIdType size, RangeBody body)
{
  constexpr vtkIdType atATime = 16;
  CaughtBody caught(body);
  for (vtkIdType next = 0; next < size;)
  {
    next = RunForAWhile(next, size, atATime, caught);
    BetweenLoops::Act();
  }
}

}
