// SPDX-License-Identifier: BSD-3-Clause
// PairIndex against its definition: pairs in order, and how many different ones come before each.
#include "Precompiled.h"

#include "Core/Memory/PairIndex.h"

namespace
{

using namespace subdivision;

template <typename Id>
using Pairs = std::vector<std::pair<Id, Id>>;

template <typename Id>
PairIndex<Id> MakeIndex(const Pairs<Id>& pairs, vtkIdType firsts)
{
  return PairIndex<Id>(static_cast<vtkIdType>(pairs.size()), firsts,
    [&pairs](const auto& use)
    {
      for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        use(static_cast<vtkIdType>(i), pairs[i].first, pairs[i].second);
      }
    });
}

template <typename Id>
void CheckByDefinition(const Pairs<Id>& pairs, const PairIndex<Id>& index)
{
  std::map<std::pair<Id, Id>, std::vector<Id>> sorted;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    sorted[pairs[i]].push_back(static_cast<Id>(i));
  }
  ASSERT_EQ(index.GetNumberOfPairs(), static_cast<vtkIdType>(pairs.size()));
  ASSERT_EQ(index.GetNumberOfRanks(), static_cast<Id>(sorted.size()));
  std::vector<std::vector<Id>> found(sorted.size()); // a rank is written by one thread
  std::vector<vtkIdType> places(sorted.size(), -1);
  index.ForRanks(
    [&](Id rank, Id first, const PairEntry<Id>* begin, const PairEntry<Id>* end)
    {
      places[rank] = index.GetPlace(begin);
      for (const PairEntry<Id>* entry = begin; entry != end; ++entry)
      {
        const std::pair<Id, Id> pair = { first, entry->GetSecond() };
        found[rank].push_back(pair == pairs[entry->GetPair()] ? entry->GetPair() : Id(-1));
      }
    });
  vtkIdType place = 0;
  std::size_t rank = 0;
  for (const auto& expected : sorted)
  {
    ASSERT_EQ(found[rank], expected.second) << rank;
    ASSERT_EQ(places[rank], place) << rank;
    place += static_cast<vtkIdType>(expected.second.size());
    ++rank;
  }
}

template <typename Id>
Pairs<Id> DrawPairs(Id firsts, Id seconds, std::size_t size, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<Id> first(0, firsts - 1);
  std::uniform_int_distribution<Id> second(0, seconds - 1);
  Pairs<Id> pairs(size);
  for (auto& pair : pairs)
  {
    pair.first = first(random);
    pair.second = second(random);
  }
  return pairs;
}

template <typename Id>
void CheckRandomPairs()
{
  // Lists of each length: short ones are sorted in another way than long ones.
  for (const Id firsts : { Id(1), Id(7), Id(300), Id(5000) })
  {
    for (const Id seconds : { Id(3), Id(2000000000) })
    {
      SCOPED_TRACE(firsts);
      const Pairs<Id> pairs = DrawPairs<Id>(firsts, seconds, 900, 5);
      CheckByDefinition(pairs, MakeIndex(pairs, firsts));
    }
  }
}

}

TEST(CorePairIndex, OfNoPairsThereAreNoRanks)
{
  for (const vtkIdType firsts : { 0, 5 })
  {
    const PairIndex<int> index = MakeIndex<int>({}, firsts);
    EXPECT_EQ(index.GetNumberOfPairs(), 0);
    EXPECT_EQ(index.GetNumberOfRanks(), 0);
    index.ForRanks([](int, int, const PairEntry<int>*, const PairEntry<int>*) { ADD_FAILURE(); });
  }
}

TEST(CorePairIndex, RandomPairsAreRankedByDefinition)
{
  CheckRandomPairs<int>();
  CheckRandomPairs<long long>();
}

TEST(CorePairIndex, ThreadsChangeNothing)
{
  // More first numbers than one thread takes alone.
  constexpr int firsts = 5 * static_cast<int>(WorthThreads);
  const Pairs<int> pairs = DrawPairs<int>(firsts, 9, 200000, 3);
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    const PairIndex<int> index = MakeIndex(pairs, firsts);
    CheckByDefinition(pairs, index);
    vtkSMPTools::Initialize(0);
  }
}
