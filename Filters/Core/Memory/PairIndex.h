// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairIndex.h
 * Ranks pairs of numbers, equal pairs alike. So BuildComplex and BuildPolygonMesh find edges, which
 * are pairs of vertices, and faces, each a pair of an edge and a vertex.
 */
#ifndef SubdivisionObjects_PairIndex_h
#define SubdivisionObjects_PairIndex_h

#include "Core/Memory/Buffer.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace subdivision
{

/// The second number of a pair, and which pair it is. Entries ascend by number, and by pair where
/// numbers are equal. With small ids both are one number, so that one comparison tells.
template <typename Id>
class PairEntry
{
public:
  PairEntry() = default;
  PairEntry(Id second, vtkIdType pair)
  {
    if constexpr (IsSmall)
    {
      this->Value = static_cast<std::uint64_t>(second) << 32 | static_cast<std::uint64_t>(pair);
    }
    else
    {
      this->Value = { second, static_cast<Id>(pair) };
    }
  }
  Id GetSecond() const
  {
    if constexpr (IsSmall)
    {
      return static_cast<Id>(this->Value >> 32);
    }
    else
    {
      return this->Value.first;
    }
  }
  Id GetPair() const
  {
    if constexpr (IsSmall)
    {
      return static_cast<Id>(this->Value & 0xffffffffu);
    }
    else
    {
      return this->Value.second;
    }
  }
  bool operator<(const PairEntry& other) const { return this->Value < other.Value; }

private:
  static constexpr bool IsSmall = sizeof(Id) == 4;

  /// As std::pair, which is not trivially copyable.
  struct Numbers
  {
    Id first;
    Id second;
    bool operator<(const Numbers& other) const
    {
      return this->first != other.first ? this->first < other.first : this->second < other.second;
    }
  };

  std::conditional_t<IsSmall, std::uint64_t, Numbers> Value;
};

/// All pairs in ascending order. Equal pairs have one rank: how many different pairs come before.
template <typename Id>
class PairIndex
{
public:
  using Entry = PairEntry<Id>;

  /// forPairs(use) calls use(pair, first, second) for pairs 0 to size - 1, each time the same;
  /// `firsts`: more than any first number.
  template <typename ForPairs>
  PairIndex(vtkIdType size, vtkIdType firsts, const ForPairs& forPairs)
    : Ends(firsts + 1, Id(0))
    , Entries(size)
    , Ranks(firsts + 1)
  {
    forPairs([this](vtkIdType, Id first, Id) { ++this->Ends[first]; });
    CountsToOffsets(this->Ends);
    forPairs([this](vtkIdType pair, Id first, Id second)
      { this->Entries[this->Ends[first]++] = Entry(second, pair); });
    ForEach(firsts,
      [this](vtkIdType first)
      {
        Sort(this->GetBegin(first), this->GetEnd(first));
        Id count = 0;
        this->ForRuns(first, [&count](const Entry*, const Entry*) { ++count; });
        this->Ranks[first] = count;
      });
    CountsToOffsets(this->Ranks);
  }

  vtkIdType GetNumberOfPairs() const { return this->Entries.size(); }
  Id GetNumberOfRanks() const { return this->Ranks[this->Ranks.size() - 1]; }
  /// Calls use(rank, first, begin, end) for each rank, in threads: the first number of its pairs,
  /// and their entries.
  template <typename Use>
  void ForRanks(const Use& use) const
  {
    ForEach(this->Ranks.size() - 1,
      [&](vtkIdType first)
      {
        Id rank = this->Ranks[first];
        this->ForRuns(first, [&](const Entry* begin, const Entry* end)
          { use(rank++, static_cast<Id>(first), begin, end); });
      });
  }
  /// Where an entry stands among all of them.
  vtkIdType GetPlace(const Entry* entry) const { return entry - this->Entries.data(); }

private:
  Entry* GetBegin(vtkIdType first)
  {
    return this->Entries.data() + (first > 0 ? this->Ends[first - 1] : Id(0));
  }
  const Entry* GetBegin(vtkIdType first) const
  {
    return this->Entries.data() + (first > 0 ? this->Ends[first - 1] : Id(0));
  }
  Entry* GetEnd(vtkIdType first) { return this->Entries.data() + this->Ends[first]; }
  const Entry* GetEnd(vtkIdType first) const { return this->Entries.data() + this->Ends[first]; }

  /// Most lists are short.
  static void Sort(Entry* begin, Entry* end)
  {
    constexpr std::ptrdiff_t shortList = 32;
    if (end - begin > shortList)
    {
      std::sort(begin, end);
      return;
    }
    for (Entry* next = begin; next < end; ++next)
    {
      const Entry entry = *next;
      Entry* place = next;
      for (; place > begin && entry < *(place - 1); --place)
      {
        *place = *(place - 1);
      }
      *place = entry;
    }
  }
  template <typename Use>
  void ForRuns(vtkIdType first, const Use& use) const
  {
    const Entry* const end = this->GetEnd(first);
    for (const Entry* entry = this->GetBegin(first); entry < end;)
    {
      const Entry* const begin = entry;
      const Id second = begin->GetSecond();
      do
      {
        ++entry;
      } while (entry < end && entry->GetSecond() == second);
      use(begin, entry);
    }
  }

  Buffer<Id> Ends; ///< of the entries with each first number
  Buffer<Entry> Entries;
  Buffer<Id> Ranks; ///< the first rank of each first number, and how many there are
};

}

#endif
