// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Memory/Loops.h"

#include "Core/Memory/UnevenRanges.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

namespace subdivision
{
namespace
{

thread_local BetweenLoops* Current = nullptr;
thread_local int DepthOfLoops = 0; ///< of those that several threads run

/// A body whose first exception goes on in the thread that began the loop: in another one, such as
/// where memory ends, it would end the program. Ranges after it are left out.
class CaughtBody
{
public:
  explicit CaughtBody(const RangeBody& body)
    : Body(body)
  {
  }
  void operator()(vtkIdType begin, vtkIdType end)
  {
    if (this->HasFailed)
    {
      return;
    }
    try
    {
      this->Body(begin, end);
    }
    catch (...)
    {
      if (!this->HasFailed.exchange(true))
      {
        this->Failure = std::current_exception();
      }
    }
  }
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
  std::atomic<bool> HasFailed{ false };
  std::exception_ptr Failure;
};

/// Runs loop(body) in several threads, of which this may be one.
template <typename Loop>
void RunInThreads(const RangeBody& body, const Loop& loop)
{
  CaughtBody caught(body);
  {
    struct Depth
    {
      Depth() { ++DepthOfLoops; }
      ~Depth() { --DepthOfLoops; }
    } const depth;
    loop(caught);
  }
  caught.Throw();
}

/// Calls run(begin, end, body) in threads for parts of [0, size), the first of which has `first`
/// elements. The next ones are as large as takes `wanted` seconds, by the time of the part before.
template <typename Run>
void RunInParts(vtkIdType size, vtkIdType first, const RangeBody& body, const Run& run)
{
  using Clock = std::chrono::steady_clock;
  constexpr double wanted = 0.02;
  constexpr double mostGrowth = 4.; // the next part may be harder work, on memory that is new
  vtkIdType most = Current ? first : size;
  for (vtkIdType begin = 0; begin < size;)
  {
    const vtkIdType end = size - begin > most ? begin + most : size;
    const auto start = Clock::now();
    RunInThreads(body, [&](CaughtBody& caught) { run(begin, end, caught); });
    const std::chrono::duration<double> taken = Clock::now() - start;
    const double factor = taken.count() * mostGrowth > wanted ? wanted / taken.count() : mostGrowth;
    most =
      std::max<vtkIdType>(1, static_cast<vtkIdType>(factor * static_cast<double>(end - begin)));
    begin = end;
    BetweenLoops::Act();
  }
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
  if (size <= WorthThreads)
  {
    body(0, size);
    BetweenLoops::Act();
    return;
  }
  RunInParts(size, inOnePart, body, [](vtkIdType begin, vtkIdType end, CaughtBody& caught)
    { vtkSMPTools::For(begin, end, caught); });
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
  RunInParts(blocks, std::max(inOnePart, worthThreads), body,
    [](vtkIdType begin, vtkIdType end, CaughtBody& caught)
    { vtkSMPTools::For(begin, end, 1, caught); });
}

void ForUnevenRanges(vtkIdType size, RangeBody body)
{
  using Clock = std::chrono::steady_clock;
  constexpr vtkIdType atATime = 16;
  const auto most = std::chrono::duration_cast<Clock::duration>(
    std::chrono::duration<double>(SecondsOfUnevenRanges));
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  std::atomic<vtkIdType> next(0);
  while (next < size)
  {
    const auto last = Clock::now() + most;
    const bool isEndless = !Current || DepthOfLoops > 0;
    const auto take = [&](vtkIdType, vtkIdType)
    {
      do // once in any case: on a busy machine threads begin when the time is up
      {
        const vtkIdType begin = next.fetch_add(atATime);
        if (begin >= size)
        {
          return;
        }
        body(begin, std::min(size, begin + atATime));
      } while (isEndless || Clock::now() < last);
    };
    RunInThreads(take, [&](CaughtBody& caught) { vtkSMPTools::For(0, threads, 1, caught); });
    BetweenLoops::Act();
  }
}

}
