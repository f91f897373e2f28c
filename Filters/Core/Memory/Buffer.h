// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Buffer.h
 * Memory for large meshes: uninitialised arrays, compressed rows and a parallel prefix sum.
 */
#ifndef SubdivisionObjects_Buffer_h
#define SubdivisionObjects_Buffer_h

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace subdivision
{

/// Asks the kernel to map all pages of a block in one call, which is much cheaper than one page
/// fault for each page. Does nothing for a small block, if there are several threads, which share
/// the page faults, or if the kernel has no such call.
void FaultPages(void* memory, std::size_t bytes);

/// Asks the kernel for huge pages in that part of a block which consists of whole huge pages. Call
/// it before the block is written. Does nothing if the kernel has no huge pages.
void AdviseHugePages(void* memory, std::size_t bytes);

/// Allocates memory that std::free releases. Large blocks get huge pages if the kernel has them:
/// most of the time for writing a large mesh goes into page faults.
void* AllocateBytes(std::size_t bytes);

/// Sets `size` elements, in threads.
template <typename T>
void Fill(T* first, vtkIdType size, T value)
{
  ForRanges(
    size, [=](vtkIdType begin, vtkIdType end) { std::fill(first + begin, first + end, value); });
}

/// Copies `size` elements, in threads, also to elements of another type.
template <typename From, typename To>
void CopyInThreads(const From* from, vtkIdType size, To* to)
{
  ForRanges(
    size, [=](vtkIdType begin, vtkIdType end) { std::copy(from + begin, from + end, to + begin); });
}

/// An array of fixed size. Without a value its elements are not initialised, so that the thread
/// which computes an element is the first to write it.
template <typename T>
class Buffer
{
  static_assert(std::is_trivially_copyable<T>::value, "Buffer holds plain values");

public:
  Buffer() = default;
  explicit Buffer(vtkIdType size)
    : Values(static_cast<T*>(AllocateBytes(sizeof(T) * static_cast<std::size_t>(size))))
    , Size(size)
  {
  }
  Buffer(vtkIdType size, T value)
    : Buffer(size)
  {
    Fill(this->Values, size, value);
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  Buffer(Buffer&& other) noexcept { this->Swap(other); }
  Buffer& operator=(Buffer&& other) noexcept
  {
    Buffer taken(std::move(other));
    this->Swap(taken);
    return *this;
  }
  ~Buffer() { std::free(this->Values); }

  T* data() { return this->Values; }
  const T* data() const { return this->Values; }
  vtkIdType size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }
  T& operator[](vtkIdType i) { return this->Values[i]; }
  const T& operator[](vtkIdType i) const { return this->Values[i]; }
  T* begin() { return this->Values; }
  T* end() { return this->Values + this->Size; }
  const T* begin() const { return this->Values; }
  const T* end() const { return this->Values + this->Size; }
  std::size_t GetMemorySize() const { return sizeof(T) * static_cast<std::size_t>(this->Size); }

private:
  void Swap(Buffer& other) noexcept
  {
    std::swap(this->Values, other.Values);
    std::swap(this->Size, other.Size);
  }

  T* Values = nullptr;
  vtkIdType Size = 0;
};

/// A view of one row of a Rows object.
template <typename Id>
struct Row
{
  const Id* First = nullptr;
  const Id* Last = nullptr;
  const Id* begin() const { return this->First; }
  const Id* end() const { return this->Last; }
  vtkIdType size() const { return this->Last - this->First; }
};

/// Compressed rows: row i is Items[Offsets[i] .. Offsets[i + 1]).
template <typename Id>
struct Rows
{
  Buffer<Id> Offsets;
  Buffer<Id> Items;

  vtkIdType GetNumberOfRows() const { return this->Offsets.size() - 1; }
  Row<Id> operator[](vtkIdType i) const
  {
    return { this->Items.data() + this->Offsets[i], this->Items.data() + this->Offsets[i + 1] };
  }
  std::size_t GetMemorySize() const
  {
    return this->Offsets.GetMemorySize() + this->Items.GetMemorySize();
  }
};

/// Replaces the counts in offsets[0 .. size - 1) by their exclusive prefix sums, and the last
/// element by the total. Throws std::length_error if ids of type int are too small for that.
template <typename Id>
void CountsToOffsets(Buffer<Id>& offsets)
{
  const vtkIdType rows = offsets.size() - 1;
  constexpr vtkIdType block = 65536;
  const vtkIdType blocks = (rows + block - 1) / block;
  const auto forBlocks = [blocks](const auto& body)
  {
    ForRangesOfBlocks(
      blocks,
      [&body](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType b = begin; b < end; ++b)
        {
          body(b, b * block);
        }
      },
      16);
  };
  Buffer<vtkIdType> starts(blocks + 1);
  forBlocks(
    [&](vtkIdType b, vtkIdType begin)
    {
      vtkIdType sum = 0;
      for (vtkIdType i = begin; i < std::min(rows, begin + block); ++i)
      {
        sum += offsets[i];
      }
      starts[b] = sum;
    });
  vtkIdType total = 0;
  for (vtkIdType b = 0; b < blocks; ++b)
  {
    total += std::exchange(starts[b], total);
  }
  if (std::is_same<Id, int>::value && total > LargestSmallId)
  {
    throw std::length_error(
      "a table of " + std::to_string(total) + " entries is too large for ids of type int");
  }
  forBlocks(
    [&](vtkIdType b, vtkIdType begin)
    {
      auto sum = static_cast<Id>(starts[b]);
      for (vtkIdType i = begin; i < std::min(rows, begin + block); ++i)
      {
        sum += std::exchange(offsets[i], sum);
      }
    });
  offsets[rows] = static_cast<Id>(total);
}

/// Lists items by their row: row r has item(i) for all i of [0, size) with row(i) == r, in
/// ascending order.
template <typename Id, typename RowOf, typename Item>
Rows<Id> ListByRow(vtkIdType rows, vtkIdType size, const RowOf& row, const Item& item)
{
  Rows<Id> lists;
  lists.Offsets = Buffer<Id>(rows + 1, Id(0));
  ForEachInTurn(size, [&](vtkIdType i) { ++lists.Offsets[row(i)]; });
  CountsToOffsets(lists.Offsets);
  lists.Items = Buffer<Id>(size);
  Buffer<Id> next(rows);
  CopyInThreads(lists.Offsets.data(), rows, next.data());
  ForEachInTurn(size, [&](vtkIdType i) { lists.Items[next[row(i)]++] = item(i); });
  return lists;
}

}

#endif
