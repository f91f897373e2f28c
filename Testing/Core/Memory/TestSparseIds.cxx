// SPDX-License-Identifier: BSD-3-Clause
// SparseIds: -1 where nothing was set, and memory for pages with ids only.
#include "Precompiled.h"

#include "Core/Memory/SparseIds.h"

namespace
{

using namespace subdivision;

constexpr vtkIdType PageSize = SparseIds<int>::PageSize;

}

TEST(CoreSparseIds, HaveNoIdAtFirst)
{
  const SparseIds<int> none;
  EXPECT_EQ(none.size(), 0);
  EXPECT_EQ(none.GetNumberOfPages(), 0);
  EXPECT_EQ(none.GetMemorySize(), 0u);
  const SparseIds<int> ids(3 * PageSize);
  EXPECT_EQ(ids.size(), 3 * PageSize);
  for (vtkIdType i = 0; i < ids.size(); ++i)
  {
    ASSERT_EQ(ids[i], -1);
  }
}

TEST(CoreSparseIds, PagesCoverAllAndNoMore)
{
  EXPECT_EQ(SparseIds<int>(1).GetNumberOfPages(), 1);
  EXPECT_EQ(SparseIds<int>(PageSize).GetNumberOfPages(), 1);
  EXPECT_EQ(SparseIds<int>(PageSize + 1).GetNumberOfPages(), 2);
  EXPECT_EQ(SparseIds<int>(5 * PageSize).GetNumberOfPages(), 5);
}

TEST(CoreSparseIds, AnIdTakesItsPageOnly)
{
  SparseIds<int> ids(4 * PageSize);
  const std::size_t before = ids.GetMemorySize();
  ids.Set(2 * PageSize, 7); // the first of a page
  ids.Set(3 * PageSize - 1, 8);
  EXPECT_EQ(ids.GetMemorySize() - before, PageSize * sizeof(int));
  for (vtkIdType p = 0; p < 4; ++p)
  {
    EXPECT_EQ(ids.GetPage(p).empty(), p != 2) << "page " << p;
  }
  const Buffer<int>& page = ids.GetPage(2);
  ASSERT_EQ(page.size(), PageSize);
  EXPECT_EQ(page[0], 7);
  EXPECT_EQ(page[1], -1);
  EXPECT_EQ(page[PageSize - 1], 8);
  EXPECT_EQ(ids[2 * PageSize - 1], -1);
  EXPECT_EQ(ids[2 * PageSize], 7);
  EXPECT_EQ(ids[3 * PageSize - 1], 8);
  EXPECT_EQ(ids[3 * PageSize], -1);
  ids.Set(2 * PageSize, 9);
  EXPECT_EQ(ids[2 * PageSize], 9) << "the last value counts";
  EXPECT_EQ(ids[3 * PageSize - 1], 8);
}

TEST(CoreSparseIds, EqualAMapOfTheSameIds)
{
  constexpr vtkIdType size = 10 * PageSize + 123;
  constexpr long long large = 1ll << 40;
  SparseIds<long long> ids(size);
  std::map<vtkIdType, long long> reference;
  std::mt19937 random(2);
  std::uniform_int_distribution<vtkIdType> draw(0, size - 1);
  for (int i = 0; i < 500; ++i)
  {
    const vtkIdType at = draw(random);
    ids.Set(at, large + i);
    reference[at] = large + i;
  }
  ids.Set(size - 1, large); // in the page that is not full
  reference[size - 1] = large;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const auto found = reference.find(i);
    ASSERT_EQ(ids[i], found == reference.end() ? -1 : found->second) << i;
  }
}
