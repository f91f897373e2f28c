// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Loops.h
 * Parallel loops, and serial ones that can be stopped. The body of a parallel loop is compiled
 * once: templates of vtkSMPTools would compile it once more for each of VTK's four back ends, which
 * took half of the time to compile Core.
 */
#ifndef SubdivisionObjects_Loops_h
#define SubdivisionObjects_Loops_h

#include "vtkType.h"

#include <chrono>
#include <functional>
#include <iterator>
#include <type_traits>

namespace subdivision
{

/**
 * As long as it lives, this thread calls `act` between its loops, and between the parts of long
 * ones, at most every SecondsBetween seconds; never inside a body that other threads run too. So
 * long work reports that it goes on. `act` may throw, which ends the work. The last one that was
 * made counts. Serial work of more than 0.1 s calls Act by Turns or ForEachInTurn.
 */
class BetweenLoops
{
public:
  explicit BetweenLoops(std::function<void()> act);
  ~BetweenLoops();
  BetweenLoops(const BetweenLoops&) = delete;
  BetweenLoops& operator=(const BetweenLoops&) = delete;

  /// Acts if it is time to; for work without loops.
  static void Act();

  /// Tests change these.
  static inline double SecondsBetween = 0.1;
  static inline int TurnsBetween = 4096;

private:
  using Clock = std::chrono::steady_clock;

  std::function<void()> Work;
  BetweenLoops* Outer;
  Clock::time_point Last;
};

/// Counts the turns of a serial loop, and acts after many of them: reading the clock in each would
/// take longer than short turns.
class Turns
{
public:
  void Next()
  {
    if (++this->Count >= BetweenLoops::TurnsBetween)
    {
      this->Count = 0;
      BetweenLoops::Act();
    }
  }

private:
  int Count = 0;
};

/// Calls body(i) for each i of [0, size) in this thread, in ascending order.
template <typename Body>
void ForEachInTurn(vtkIdType size, const Body& body)
{
  vtkIdType i = 0;
  for (const vtkIdType turns = BetweenLoops::TurnsBetween; size - i >= turns;)
  {
    for (const vtkIdType end = i + turns; i < end; ++i) // without a count: turns may be short
    {
      body(i);
    }
    BetweenLoops::Act();
  }
  for (; i < size; ++i)
  {
    body(i);
  }
}

/// The items from one iterator to another. A loop over them acts after many turns.
template <typename Iterator>
class ItemsInTurn
{
public:
  ItemsInTurn(Iterator begin, Iterator end)
    : Begin(begin)
    , End(end)
  {
  }

  class Step
  {
  public:
    explicit Step(Iterator at)
      : At(at)
    {
    }
    decltype(auto) operator*() const { return *this->At; }
    Step& operator++()
    {
      ++this->At;
      this->Done.Next();
      return *this;
    }
    bool operator!=(const Step& other) const { return this->At != other.At; }

  private:
    Iterator At;
    Turns Done;
  };

  Step begin() const { return Step(this->Begin); }
  Step end() const { return Step(this->End); }

private:
  Iterator Begin;
  Iterator End;
};

/// A number as an iterator over numbers.
template <typename Number>
struct CountingIterator
{
  Number Value;
  Number operator*() const { return this->Value; }
  CountingIterator& operator++()
  {
    ++this->Value;
    return *this;
  }
  bool operator!=(const CountingIterator& other) const { return this->Value < other.Value; }
};

/// `for (vtkIdType i : InTurn(size))` counts to size - 1, and `for (Id x : InTurn(list))` visits
/// the items of a list, as loops of the language do, but they act after many turns. For loops that
/// ForEachInTurn does not fit, such as loops that end early.
template <typename Number, std::enable_if_t<std::is_integral<Number>::value, bool> = true>
ItemsInTurn<CountingIterator<Number>> InTurn(Number size)
{
  return { { Number(0) }, { size } };
}
template <typename List, std::enable_if_t<!std::is_integral<List>::value, bool> = true>
auto InTurn(List& list)
{
  return ItemsInTurn<decltype(std::begin(list))>(std::begin(list), std::end(list));
}

/// A reference to a callable body(begin, end), which must outlive it. It costs one indirect call
/// for each range, not for each element.
class RangeBody
{
public:
  template <typename Body>
  RangeBody(const Body& body)
    : Object(&body)
    , Call([](const void* object, vtkIdType begin, vtkIdType end)
        { (*static_cast<const Body*>(object))(begin, end); })
  {
  }
  void operator()(vtkIdType begin, vtkIdType end) const { this->Call(this->Object, begin, end); }

private:
  const void* Object;
  void (*Call)(const void*, vtkIdType, vtkIdType);
};

/// Loops shorter than this are not worth starting threads for, which takes some 0.1 ms.
constexpr vtkIdType WorthThreads = 8192;

/// Calls body(begin, end) for disjoint ranges that cover [0, size); in several threads if `size`
/// exceeds WorthThreads. This and all loops below throw the first exception of a body, in whatever
/// thread it was.
void ForRanges(vtkIdType size, RangeBody body);

/// Calls body(begin, end) for ranges of blocks; in several threads if there are at least
/// `worthThreads` blocks, each of which is then worth a thread.
void ForRangesOfBlocks(vtkIdType blocks, RangeBody body, vtkIdType worthThreads = 2);

/// Calls body(i) for each i of [0, size), as ForRanges does.
template <typename Body>
void ForEach(vtkIdType size, const Body& body)
{
  ForRanges(size,
    [&body](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        body(i);
      }
    });
}

}

#endif
