// SPDX-License-Identifier: BSD-3-Clause
// Plain memory and plain loops: Buffer, GrowingBuffer, Rows, ForEach, ForRanges, CountsToOffsets.
#include "Precompiled.h"

#include "Core/Memory/GrowingBuffer.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace
{

using namespace subdivision;

template <typename T>
std::vector<T> ToVector(const Buffer<T>& buffer)
{
  return std::vector<T>(buffer.begin(), buffer.end());
}

/// Several threads for a while, although the machine may have one core only.
class FourThreads
{
public:
  FourThreads() { vtkSMPTools::Initialize(4); }
  ~FourThreads() { vtkSMPTools::Initialize(0); }
};

/// Sizes around those from which on threads work, and one that takes many of them.
const std::vector<vtkIdType> LoopSizes = { 0, 1, 2, WorthThreads - 1, WorthThreads,
  WorthThreads + 1, 300000 };

}

TEST(CoreBuffer, KnowsItsSizeAndItsBytes)
{
  const Buffer<double> none;
  EXPECT_EQ(none.size(), 0);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.data(), nullptr);
  EXPECT_EQ(none.begin(), none.end());
  EXPECT_EQ(none.GetMemorySize(), 0u);
  const Buffer<double> zero(0);
  EXPECT_TRUE(zero.empty());
  EXPECT_EQ(zero.begin(), zero.end());
  const Buffer<double> three(3, 2.5);
  EXPECT_EQ(three.size(), 3);
  EXPECT_FALSE(three.empty());
  EXPECT_EQ(three.end() - three.begin(), 3);
  EXPECT_EQ(three.GetMemorySize(), 24u);
  EXPECT_EQ(ToVector(three), (std::vector<double>{ 2.5, 2.5, 2.5 }));
}

TEST(CoreBuffer, MovesItsElementsAndIsNeverCopied)
{
  static_assert(!std::is_copy_constructible<Buffer<int>>::value, "no copies by accident");
  static_assert(!std::is_copy_assignable<Buffer<int>>::value, "no copies by accident");
  static_assert(std::is_nothrow_move_constructible<Buffer<int>>::value, "vectors move them");
  Buffer<int> from(4, 7);
  const int* place = from.data();
  Buffer<int> to(std::move(from));
  EXPECT_EQ(to.data(), place);
  EXPECT_EQ(to.size(), 4);
  EXPECT_EQ(from.size(), 0); // NOLINT: what is left of it is empty
  EXPECT_EQ(from.data(), nullptr);
  Buffer<int> other(2, 1);
  other = std::move(to);
  EXPECT_EQ(other.data(), place);
  EXPECT_EQ(ToVector(other), (std::vector<int>{ 7, 7, 7, 7 }));
  EXPECT_EQ(to.size(), 0); // NOLINT: it does not get what the other one had
  EXPECT_EQ(to.data(), nullptr);
  Buffer<int>& itself = other;
  other = std::move(itself);
  EXPECT_EQ(other.data(), place);
  EXPECT_EQ(other.size(), 4);
}

TEST(CoreBuffer, LargeBlocksBeginAtHugePages)
{
  constexpr std::size_t hugePage = std::size_t(1) << 21;
  for (const std::size_t bytes : { std::size_t(0), std::size_t(1), hugePage / 2 - 1, hugePage / 2,
         hugePage, hugePage + 1, 2 * hugePage - 1, 3 * hugePage + hugePage / 2 })
  {
    auto* memory = static_cast<unsigned char*>(AllocateBytes(bytes));
    ASSERT_NE(memory, nullptr) << bytes;
#ifndef _WIN32
    if (bytes >= hugePage / 2)
    {
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % hugePage, 0u) << bytes;
    }
#endif
    std::fill(memory, memory + bytes, static_cast<unsigned char>(170));
    EXPECT_EQ(std::count(memory, memory + bytes, 170), static_cast<std::ptrdiff_t>(bytes));
    std::free(memory);
  }
}

TEST(CoreBuffer, AskingTheKernelForPagesChangesNoValue)
{
  vtkSMPTools::Initialize(1); // several threads share the faults: FaultPages then does nothing
  std::vector<unsigned char> values(std::size_t(5) << 20);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<unsigned char>(i % 251);
  }
  const std::vector<unsigned char> before = values;
  FaultPages(values.data() + 1, values.size() - 2);
  AdviseHugePages(values.data() + 1, values.size() - 2);
  FaultPages(values.data(), 100);
  FaultPages(nullptr, values.size());
  vtkSMPTools::Initialize(0);
  EXPECT_TRUE(values == before);
}

TEST(CoreBuffer, WhatIsTooLargeThrows)
{
  volatile vtkIdType most = VTK_ID_MAX; // unknown to the compiler, which would warn
  EXPECT_THROW({ const Buffer<char> large(most); }, std::bad_alloc);
}

TEST(CoreRows, AreTheItemsBetweenTwoOffsets)
{
  Rows<int> rows;
  rows.Offsets = Buffer<int>(4);
  rows.Items = Buffer<int>(5);
  const std::vector<int> offsets = { 0, 2, 2, 5 };
  std::copy(offsets.begin(), offsets.end(), rows.Offsets.begin());
  std::iota(rows.Items.begin(), rows.Items.end(), 10);
  ASSERT_EQ(rows.GetNumberOfRows(), 3);
  const std::vector<std::vector<int>> expected = { { 10, 11 }, {}, { 12, 13, 14 } };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    const Row<int> row = rows[i];
    EXPECT_EQ(row.size(), static_cast<vtkIdType>(expected[i].size()));
    EXPECT_EQ(std::vector<int>(row.begin(), row.end()), expected[i]) << "row " << i;
  }
  EXPECT_EQ(rows.GetMemorySize(), (4 + 5) * sizeof(int));
}

TEST(CoreLoops, RangesCoverEachIndexOnce)
{
  const FourThreads threads;
  for (const vtkIdType size : LoopSizes)
  {
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(size));
    std::mutex mutex;
    std::set<std::pair<vtkIdType, vtkIdType>> ranges;
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          ++visits[static_cast<std::size_t>(i)];
        }
        const std::lock_guard<std::mutex> lock(mutex);
        ranges.insert({ begin, end });
      });
    EXPECT_EQ(
      std::count(visits.begin(), visits.end(), 1), static_cast<std::ptrdiff_t>(visits.size()))
      << size;
    if (size <= WorthThreads)
    {
      // Threads would cost more than such a loop: it runs at once, as one range.
      EXPECT_EQ(ranges, (std::set<std::pair<vtkIdType, vtkIdType>>{ { 0, size } }));
    }
  }
}

TEST(CoreLoops, ForEachVisitsEachIndexOnce)
{
  const FourThreads threads;
  for (const vtkIdType size : LoopSizes)
  {
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(size));
    ForEach(size, [&](vtkIdType i) { ++visits[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(
      std::count(visits.begin(), visits.end(), 1), static_cast<std::ptrdiff_t>(visits.size()))
      << size;
  }
}

TEST(CoreCountsToOffsets, AreExclusiveSumsWithTheTotalLast)
{
  Buffer<int> few(4);
  const std::vector<int> counts = { 2, 0, 3, -77 }; // the last one is written, never read
  std::copy(counts.begin(), counts.end(), few.begin());
  CountsToOffsets(few);
  EXPECT_EQ(ToVector(few), (std::vector<int>{ 0, 2, 2, 5 }));
  Buffer<int> noRows(1, -77);
  CountsToOffsets(noRows);
  EXPECT_EQ(ToVector(noRows), std::vector<int>{ 0 });
}

// The sums are made in blocks of 65536 rows, in threads from 16 blocks on.
TEST(CoreCountsToOffsets, TooManyForIntAreAnError)
{
  Buffer<int> offsets(4);
  std::fill(offsets.begin(), offsets.end(), 1 << 30);
  EXPECT_THROW(CountsToOffsets(offsets), std::length_error);
  Buffer<long long> large(4);
  std::fill(large.begin(), large.end(), 1 << 30);
  CountsToOffsets(large);
  EXPECT_EQ(large[3], 3LL << 30);
}

TEST(CoreCountsToOffsets, BlocksJoinWithoutASeam)
{
  const FourThreads threads;
  constexpr vtkIdType block = 65536;
  for (const vtkIdType rows :
    { block - 1, block, block + 1, 3 * block, 15 * block + 1, 16 * block, 17 * block + 5 })
  {
    Buffer<long long> offsets(rows + 1, -77);
    std::vector<long long> expected(static_cast<std::size_t>(rows) + 1);
    long long sum = 0;
    for (vtkIdType i = 0; i < rows; ++i)
    {
      offsets[i] = (i * 7919) % 23;
      expected[static_cast<std::size_t>(i)] = sum;
      sum += offsets[i];
    }
    expected.back() = sum;
    CountsToOffsets(offsets);
    EXPECT_TRUE(std::equal(offsets.begin(), offsets.end(), expected.begin())) << rows << " rows";
  }
}

TEST(CoreGrowingBuffer, KeepsItsElementsWhileItGrows)
{
  GrowingBuffer<int> list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.size(), 0);
  std::size_t memory = 0;
  int growths = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i)
  {
    list.push_back(3 * i);
    EXPECT_EQ(list.back(), 3 * i);
    ASSERT_GE(list.GetMemorySize(), sizeof(int) * static_cast<std::size_t>(list.size()));
    growths += list.GetMemorySize() != memory;
    memory = list.GetMemorySize();
  }
  EXPECT_FALSE(list.empty());
  ASSERT_EQ(list.size(), count);
  for (int i = 0; i < count; ++i)
  {
    ASSERT_EQ(list[i], 3 * i);
  }
  // Room doubles: otherwise the copies take quadratic time.
  EXPECT_LE(growths, 10);
}

TEST(CoreGrowingBuffer, ExtendSaysWhereTheNewElementsAre)
{
  GrowingBuffer<int> list;
  list.push_back(1);
  int* added = list.Extend(300); // more than there is room for
  ASSERT_EQ(list.size(), 301);
  EXPECT_EQ(added, list.data() + 1);
  std::iota(added, added + 300, 2);
  int growths = 0;
  std::size_t memory = list.GetMemorySize();
  for (int i = 302; i <= 5000; i += 2)
  {
    added = list.Extend(2);
    ASSERT_EQ(added, list.data() + i - 1);
    added[0] = i;
    added[1] = i + 1;
    growths += list.GetMemorySize() != memory;
    memory = list.GetMemorySize();
  }
  for (vtkIdType i = 0; i < list.size(); ++i)
  {
    ASSERT_EQ(list[i], static_cast<int>(i) + 1);
  }
  EXPECT_LE(growths, 6);
  EXPECT_EQ(list.Extend(0), list.data() + list.size());
}

TEST(CoreGrowingBuffer, ReserveMakesRoomAndAddsNothing)
{
  GrowingBuffer<int> list;
  list.push_back(5);
  list.Reserve(1000);
  EXPECT_EQ(list.size(), 1);
  EXPECT_EQ(list[0], 5);
  const int* place = list.data();
  const std::size_t memory = list.GetMemorySize();
  EXPECT_EQ(memory, 1000 * sizeof(int));
  list.Reserve(10);
  EXPECT_EQ(list.GetMemorySize(), memory);
  for (int i = 1; i < 1000; ++i)
  {
    list.push_back(i);
  }
  EXPECT_EQ(list.data(), place) << "there was room";
  list.push_back(1000);
  EXPECT_GT(list.GetMemorySize(), memory);
  EXPECT_EQ(list[0], 5);
  EXPECT_EQ(list[999], 999);
}

TEST(CoreGrowingBuffer, CopyHasNoRoomForMore)
{
  GrowingBuffer<int> list;
  EXPECT_EQ(list.Copy().size(), 0);
  for (int i = 0; i < 5; ++i)
  {
    list.push_back(i);
  }
  list.pop_back();
  list.pop_back();
  EXPECT_EQ(list.size(), 3);
  EXPECT_EQ(list.back(), 2);
  const Buffer<int> copy = list.Copy();
  EXPECT_EQ(ToVector(copy), (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(copy.GetMemorySize(), 3 * sizeof(int));
  list.push_back(9);
  EXPECT_EQ(list[3], 9);
  EXPECT_EQ(list.size(), 4);
}
