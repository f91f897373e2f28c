// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Buffer.h
 * Memory and loops for large meshes: uninitialised arrays, compressed rows, parallel loops and a
 * parallel prefix sum.
 */
#ifndef SubdivisionObjects_Buffer_h
#define SubdivisionObjects_Buffer_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace subdivision
{

/// Asks the kernel to map all pages of a block in one call, which is much cheaper than one page
/// fault for each page. Does nothing for a small block, if there are several threads, which share
/// the page faults, or if the kernel has no such call.
inline void FaultPages(void* memory, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
  constexpr std::size_t page = 4096;
  if (!memory || bytes < 16 * page || vtkSMPTools::GetEstimatedNumberOfThreads() > 1)
  {
    return;
  }
  const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  (void)madvise(
    static_cast<char*>(memory) + skipped, (bytes - skipped) / page * page, MADV_POPULATE_WRITE);
#else
  (void)memory;
  (void)bytes;
#endif
}

/// Asks the kernel for huge pages in that part of a block which consists of whole huge pages. Call
/// it before the block is written. Does nothing if the kernel has no huge pages.
inline void AdviseHugePages(void* memory, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  const std::size_t skipped =
    (hugePage - reinterpret_cast<std::uintptr_t>(memory) % hugePage) % hugePage;
  if (bytes >= skipped + hugePage)
  {
    (void)madvise(
      static_cast<char*>(memory) + skipped, (bytes - skipped) / hugePage * hugePage, MADV_HUGEPAGE);
  }
#else
  (void)memory;
  (void)bytes;
#endif
}

/// Allocates memory that std::free releases. Large blocks get huge pages if the kernel has them:
/// most of the time for writing a large mesh goes into page faults.
inline void* AllocateBytes(std::size_t bytes)
{
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  // The last page is huge too where at least half of it is used.
  const std::size_t huge = (bytes + hugePage / 2) / hugePage * hugePage;
  void* memory = nullptr;
  if (huge == 0)
  {
    memory = std::malloc(std::max<std::size_t>(bytes, 1));
    FaultPages(memory, bytes);
  }
  else
  {
    const std::size_t rounded = (bytes + hugePage - 1) / hugePage * hugePage;
#ifdef _WIN32
    memory = std::malloc(rounded);
#else
    memory = std::aligned_alloc(hugePage, rounded);
#endif
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (memory)
    {
      (void)madvise(memory, huge, MADV_HUGEPAGE);
    }
#endif
  }
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
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
    std::fill(this->begin(), this->end(), value);
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

/// Loops shorter than this are not worth starting threads for, which takes some 0.1 ms.
constexpr vtkIdType WorthThreads = 8192;

/// Calls body(begin, end) for disjoint ranges that cover [0, size); in several threads if `size`
/// exceeds WorthThreads.
template <typename Body>
void ForRanges(vtkIdType size, const Body& body)
{
  if (size <= WorthThreads)
  {
    body(vtkIdType(0), size);
    return;
  }
  auto ranges = [&body](vtkIdType begin, vtkIdType end) { body(begin, end); };
  vtkSMPTools::For(0, size, ranges);
}

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

/// Replaces the counts in offsets[0 .. size - 1) by their exclusive prefix sums, and the last
/// element by the total.
template <typename Id>
void CountsToOffsets(Buffer<Id>& offsets)
{
  const vtkIdType rows = offsets.size() - 1;
  constexpr vtkIdType block = 65536;
  const vtkIdType blocks = (rows + block - 1) / block;
  auto forBlocks = [blocks](const auto& body)
  {
    auto ranges = [&body](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType b = begin; b < end; ++b)
      {
        body(b, b * block);
      }
    };
    if (blocks < 16)
    {
      ranges(0, blocks);
      return;
    }
    vtkSMPTools::For(0, blocks, 1, ranges);
  };
  Buffer<Id> starts(blocks + 1);
  forBlocks(
    [&](vtkIdType b, vtkIdType begin)
    {
      Id sum = 0;
      for (vtkIdType i = begin; i < std::min(rows, begin + block); ++i)
      {
        sum += offsets[i];
      }
      starts[b] = sum;
    });
  Id total = 0;
  for (vtkIdType b = 0; b < blocks; ++b)
  {
    total += std::exchange(starts[b], total);
  }
  forBlocks(
    [&](vtkIdType b, vtkIdType begin)
    {
      Id sum = starts[b];
      for (vtkIdType i = begin; i < std::min(rows, begin + block); ++i)
      {
        sum += std::exchange(offsets[i], sum);
      }
    });
  offsets[rows] = total;
}

}

#endif
