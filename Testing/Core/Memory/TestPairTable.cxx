// SPDX-License-Identifier: BSD-3-Clause
// PairTable against a map, while it grows, and with ids of 64 bits.
#include "Precompiled.h"

#include "Core/Memory/PairTable.h"

namespace
{

using namespace subdivision;

/// Adds pairs of ids up to `most`, some of them again, and compares with a map.
template <typename Id>
void CompareWithMap(Id most, int pairs)
{
  std::mt19937_64 random(5);
  std::uniform_int_distribution<Id> draw(0, most);
  PairTable<Id> table;
  std::map<std::pair<Id, Id>, Id> reference;
  for (int i = 0; i < pairs; ++i)
  {
    const Id a = draw(random);
    const Id b = draw(random);
    const auto pair = std::minmax(a, b);
    const auto found = reference.find(pair);
    ASSERT_EQ(table.Find(a, b), found == reference.end() ? Id(-1) : found->second);
    const Id value = reference.insert({ pair, static_cast<Id>(i) }).first->second;
    ASSERT_EQ(table.FindOrAdd(a, b, static_cast<Id>(i)), value);
  }
  for (const auto& entry : reference)
  {
    ASSERT_EQ(table.Find(entry.first.first, entry.first.second), entry.second);
    ASSERT_EQ(table.Find(entry.first.second, entry.first.first), entry.second);
  }
  for (int i = 0; i < pairs; ++i)
  {
    const Id a = draw(random);
    const Id b = draw(random);
    const auto found = reference.find(std::minmax(a, b));
    ASSERT_EQ(table.Find(a, b), found == reference.end() ? Id(-1) : found->second);
  }
}

}

TEST(CorePairTable, FindsNothingInAnEmptyTable)
{
  const PairTable<int> table;
  EXPECT_EQ(table.Find(0, 1), -1);
  EXPECT_EQ(table.GetMemorySize(), 0u);
}

TEST(CorePairTable, OrderOfThePairDoesNotCount)
{
  PairTable<int> table;
  EXPECT_EQ(table.FindOrAdd(4, 2, 0), 0) << "0 is a value like any other";
  EXPECT_EQ(table.Find(4, 2), 0);
  EXPECT_EQ(table.Find(2, 4), 0);
  EXPECT_EQ(table.FindOrAdd(2, 4, 17), 0) << "the first value stays";
  EXPECT_EQ(table.FindOrAdd(3, 3, 5), 5);
  EXPECT_EQ(table.Find(3, 3), 5);
  EXPECT_EQ(table.Find(2, 2), -1);
  EXPECT_EQ(table.Find(4, 4), -1);
  EXPECT_EQ(table.Find(0, 0), -1) << "empty places hold the ids 0, 0";
}

TEST(CorePairTable, EqualsAMapWhileItGrows)
{
  CompareWithMap<int>(150, 30000);     // most pairs come again
  CompareWithMap<int>(1000000, 30000); // hardly any
}

// Pairs that agree in their lower 32 bits are different all the same.
TEST(CorePairTable, TakesIdsOf64Bits)
{
  constexpr long long high = 1ll << 32;
  PairTable<long long> table;
  EXPECT_EQ(table.FindOrAdd(1, 2, 10), 10);
  EXPECT_EQ(table.FindOrAdd(1, 2 + high, 11), 11);
  EXPECT_EQ(table.FindOrAdd(1 + high, 2 + high, 12), 12);
  EXPECT_EQ(table.FindOrAdd(1 + high, 2, 13 + high), 13 + high);
  EXPECT_EQ(table.Find(2, 1), 10);
  EXPECT_EQ(table.Find(2 + high, 1), 11);
  EXPECT_EQ(table.Find(2 + high, 1 + high), 12);
  EXPECT_EQ(table.Find(2, 1 + high), 13 + high);
  EXPECT_EQ(table.Find(1, 1 + high), -1);
  CompareWithMap<long long>(1ll << 60, 20000);
}

TEST(CorePairTable, ReserveMakesRoomForSoManyPairs)
{
  for (const int size : { 100, 512, 513, 5000 })
  {
    PairTable<int> table;
    table.FindOrAdd(0, 1, 0);
    table.Reserve(size);
    EXPECT_EQ(table.Find(1, 0), 0) << "what was in it stays";
    const std::size_t memory = table.GetMemorySize();
    for (int i = 1; i < size; ++i)
    {
      table.FindOrAdd(i, i + 1, i);
    }
    EXPECT_EQ(table.GetMemorySize(), memory) << size;
    for (int i = 0; i < size; ++i)
    {
      ASSERT_EQ(table.Find(i + 1, i), i);
    }
    table.Reserve(size);
    EXPECT_EQ(table.GetMemorySize(), memory) << "there is room already";
  }
}

// A table that is full has no empty place at which a search could end.
TEST(CorePairTable, IsNeverMoreThanHalfFull)
{
  PairTable<int> table;
  std::size_t bytesOfOne = 0;
  for (int i = 0; i < 3000; ++i)
  {
    table.FindOrAdd(i, 2 * i + 1, i);
    bytesOfOne = bytesOfOne ? bytesOfOne : table.GetMemorySize() / 1024;
    ASSERT_GE(table.GetMemorySize(), 2 * bytesOfOne * static_cast<std::size_t>(i + 1));
  }
  EXPECT_EQ(bytesOfOne, 3 * sizeof(int));
}
