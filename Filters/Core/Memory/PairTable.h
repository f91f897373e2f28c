// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PairTable.h
 * A hash table from unordered pairs of ids, such as the ends of an edge, to numbers. It grows, and
 * pairs are never removed.
 */
#ifndef SubdivisionObjects_PairTable_h
#define SubdivisionObjects_PairTable_h

#include "Core/Memory/Buffer.h"

namespace subdivision
{

template <typename Id>
class PairTable
{
public:
  /// The value of the pair { a, b } = { b, a }, -1 if it has none.
  Id Find(Id a, Id b) const
  {
    return this->Slots.empty() ? Id(-1) : this->Slots[this->Locate(a, b)].Value;
  }
  /// The value of the pair; if it has none, it gets `value`.
  Id FindOrAdd(Id a, Id b, Id value)
  {
    if (2 * this->Size >= this->Slots.size())
    {
      this->Grow(std::max<vtkIdType>(1024, 4 * this->Slots.size()));
    }
    Slot& slot = this->Slots[this->Locate(a, b)];
    if (slot.Value < 0)
    {
      slot = { std::min(a, b), std::max(a, b), value };
      ++this->Size;
    }
    return slot.Value;
  }
  /// Makes room for `size` pairs in all.
  void Reserve(vtkIdType size)
  {
    vtkIdType slots = std::max<vtkIdType>(1024, this->Slots.size());
    while (slots < 2 * size)
    {
      slots *= 2;
    }
    if (slots > this->Slots.size())
    {
      this->Grow(slots);
    }
  }
  std::size_t GetMemorySize() const { return this->Slots.GetMemorySize(); }

private:
  struct Slot
  {
    Id Smaller;
    Id Larger;
    Id Value; ///< -1: empty
  };

  /// The slot that has the pair, or the empty one where it belongs.
  vtkIdType Locate(Id a, Id b) const
  {
    const Id smaller = std::min(a, b);
    const Id larger = std::max(a, b);
    unsigned long long hash = static_cast<unsigned long long>(smaller) * 0x9E3779B97F4A7C15ull +
      static_cast<unsigned long long>(larger);
    hash *= 0xD6E8FEB86659FD93ull;
    hash ^= hash >> 32;
    const auto mask = static_cast<unsigned long long>(this->Slots.size() - 1);
    auto i = static_cast<vtkIdType>(hash & mask);
    while (this->Slots[i].Value >= 0 &&
      (this->Slots[i].Smaller != smaller || this->Slots[i].Larger != larger))
    {
      i = (i + 1) & static_cast<vtkIdType>(mask);
    }
    return i;
  }
  void Grow(vtkIdType slots)
  {
    const Buffer<Slot> old = std::move(this->Slots);
    this->Slots = Buffer<Slot>(slots, Slot{ 0, 0, -1 });
    ForEachInTurn(old.size(),
      [&](vtkIdType i)
      {
        if (old[i].Value >= 0)
        {
          this->Slots[this->Locate(old[i].Smaller, old[i].Larger)] = old[i];
        }
      });
  }

  Buffer<Slot> Slots; ///< their number is a power of two, and at most half of them are in use
  vtkIdType Size = 0;
};

}

#endif
