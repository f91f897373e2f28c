// SPDX-License-Identifier: BSD-3-Clause
// StableSort and SortDistinct: the order of std::stable_sort, for all sizes around those of blocks.
#include "Precompiled.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Sorting.h"

TEST(StableSort, IsThatOfTheStandard)
{
  using Value = std::pair<int, int>;
  const auto less = [](const Value& a, const Value& b) { return a.first < b.first; };
  std::mt19937 chance(3);
  constexpr int block = 1 << 15;
  for (const int size : { 0, 1, 2, 100, block - 1, block, block + 1, 3 * block, 5 * block + 7 })
  {
    for (const int different : { 1, 10, 1 << 30 })
    {
      std::vector<Value> values;
      for (int i = 0; i < size; ++i)
      {
        values.emplace_back(static_cast<int>(chance() % static_cast<unsigned int>(different)), i);
      }
      std::vector<Value> expected = values;
      std::stable_sort(expected.begin(), expected.end(), less);
      subdivision::StableSort(values, less);
      EXPECT_EQ(values, expected) << size << " values, at most " << different << " different";
    }
  }
}

TEST(StableSort, SortsBuffersAndKeepsOneOfEqualValues)
{
  constexpr vtkIdType size = 100000;
  subdivision::Buffer<int> buffer(size);
  std::vector<int> values;
  std::mt19937 chance(5);
  for (vtkIdType i = 0; i < size; ++i)
  {
    buffer[i] = static_cast<int>(chance() % 5000);
    values.push_back(buffer[i]);
  }
  subdivision::StableSort(buffer, std::less<>());
  EXPECT_TRUE(std::is_sorted(buffer.begin(), buffer.end()));
  std::vector<int> expected(buffer.begin(), buffer.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  subdivision::SortDistinct(values);
  EXPECT_EQ(values, expected);
}
