// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Turns.h
 * Long tests run all their rounds, or a third of them by turns of the commit: `./dev test` names
 * the third in SUBDIVISIONOBJECTS_TURN (0, 1 or 2).
 */
#ifndef SubdivisionObjects_Turns_h
#define SubdivisionObjects_Turns_h

#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
#include <type_traits>
#include <vector>

namespace turns
{

/// The third that runs; -1: all of it.
inline int GetTurn()
{
  const char* turn = std::getenv("SUBDIVISIONOBJECTS_TURN");
  return turn && *turn ? std::atoi(turn) : -1;
}

/// Whether a round runs. Of loops inside each other not always the same innermost rounds do.
inline bool IsInTurn(std::size_t round)
{
  return GetTurn() < 0 || (round + round / 3) % 3 == static_cast<std::size_t>(GetTurn());
}

/// The same of the next round of the process, which CTest starts for each test.
inline bool IsNextInTurn()
{
  static std::size_t round = 0;
  return IsInTurn(round++);
}

/// Those items whose rounds run, for a loop over them.
template <typename Items>
auto Some(const Items& items)
{
  std::vector<std::decay_t<decltype(*std::begin(items))>> some;
  for (const auto& item : items)
  {
    IsNextInTurn() ? some.push_back(item) : void();
  }
  return some;
}
template <typename Item>
std::vector<Item> Some(std::initializer_list<Item> items)
{
  return Some<std::initializer_list<Item>>(items);
}

/// How many run of so many rounds that are drawn at random, with GetTurn() in the seed.
template <typename Count>
inline Count GetShare(Count count)
{
  return GetTurn() < 0 ? count : (count + 2) / 3;
}

}

#endif
