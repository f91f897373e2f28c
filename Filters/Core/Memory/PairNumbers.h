// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairNumbers.h
 * Numbers of the pairs of a PairIndex, some of which come first.
 */
#ifndef SubdivisionObjects_PairNumbers_h
#define SubdivisionObjects_PairNumbers_h

#include "Core/Memory/PairIndex.h"

namespace subdivision
{

/// Numbers of pairs: first the pairs that occur among leading ones, in the order of their first
/// occurrence; then all others in ascending order.
template <typename Id>
struct PairNumbers
{
  Buffer<Id> Ranks;   ///< of pairs
  Buffer<Id> Numbers; ///< of ranks; empty: the same
  Buffer<Id> Firsts;  ///< the first pair of each number

  Id operator[](vtkIdType pair) const { return this->GetNumber(this->Ranks[pair]); }
  Id GetNumber(Id rank) const { return this->Numbers.empty() ? rank : this->Numbers[rank]; }
  /// Whether a pair has the number of an earlier one.
  bool IsRepeated(vtkIdType pair) const { return this->Firsts[(*this)[pair]] != pair; }

  /// Calls visit(rank, first, begin, end) as PairIndex does, too.
  template <typename Visit>
  PairNumbers(const PairIndex<Id>& index, vtkIdType leading, const Visit& visit)
    : Ranks(index.GetNumberOfPairs())
    , Firsts(index.GetNumberOfRanks())
  {
    index.ForRanks(
      [&](Id rank, Id first, const PairEntry<Id>* begin, const PairEntry<Id>* end)
      {
        this->Firsts[rank] = begin->GetPair();
        for (const PairEntry<Id>* entry = begin; entry < end; ++entry)
        {
          this->Ranks[entry->GetPair()] = rank;
        }
        visit(rank, first, begin, end);
      });
    if (leading > 0)
    {
      this->PutFirst(leading);
    }
  }
  PairNumbers() = default;

private:
  void PutFirst(vtkIdType leading)
  {
    const vtkIdType size = this->Firsts.size();
    this->Numbers = Buffer<Id>(size);
    Buffer<Id> firsts(size);
    Id next = 0;
    const auto add = [&](Id rank)
    {
      firsts[next] = this->Firsts[rank];
      this->Numbers[rank] = next++;
    };
    ForEachInTurn(leading,
      [&](vtkIdType pair)
      {
        if (this->Firsts[this->Ranks[pair]] == pair)
        {
          add(this->Ranks[pair]);
        }
      });
    ForEachInTurn(size,
      [&](vtkIdType rank)
      {
        if (this->Firsts[rank] >= leading)
        {
          add(static_cast<Id>(rank));
        }
      });
    this->Firsts = std::move(firsts);
  }
};

/// The numbers of pairs from `first` on.
template <typename Id>
Buffer<Id> TakeNumbers(PairNumbers<Id>& numbers, vtkIdType first, vtkIdType size)
{
  if (numbers.Numbers.empty() && size == numbers.Ranks.size())
  {
    return std::move(numbers.Ranks);
  }
  Buffer<Id> taken(size);
  ForEach(size, [&](vtkIdType i) { taken[i] = numbers[first + i]; });
  return taken;
}

}

#endif
