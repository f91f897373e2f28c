// SPDX-License-Identifier: BSD-3-Clause
// NumberTuples against its definition: leading tuples first, then the others by their vertices.
#include "Precompiled.h"

#include "Core/Memory/TupleIndex.h"

namespace
{

using namespace subdivision;

template <int N, typename Id>
using Tuples = Buffer<std::array<Id, N>>;

template <int N, typename Id>
Tuples<N, Id> ToTuples(const std::vector<std::array<Id, N>>& list)
{
  Tuples<N, Id> tuples(static_cast<vtkIdType>(list.size()));
  std::copy(list.begin(), list.end(), tuples.begin());
  return tuples;
}

template <typename Id>
std::vector<Id> ToVector(const Buffer<Id>& buffer)
{
  return std::vector<Id>(buffer.begin(), buffer.end());
}

/// By definition, one tuple after the other.
template <int N, typename Id>
void CheckByDefinition(
  const Tuples<N, Id>& tuples, const TupleNumbers<Id>& result, vtkIdType leading)
{
  std::map<std::array<Id, N>, Id> numbers;
  std::vector<Id> representatives;
  auto number = [&](const std::array<Id, N>& tuple, vtkIdType i)
  {
    if (numbers.insert({ tuple, static_cast<Id>(representatives.size()) }).second)
    {
      representatives.push_back(static_cast<Id>(i));
    }
  };
  for (vtkIdType i = 0; i < leading; ++i)
  {
    number(tuples[i], i);
  }
  std::map<std::array<Id, N>, vtkIdType> others;
  for (vtkIdType i = leading; i < tuples.size(); ++i)
  {
    others.insert({ tuples[i], i }); // the first one of equal ones stays
  }
  for (const auto& other : others)
  {
    number(other.first, other.second);
  }
  ASSERT_EQ(result.Numbers.size(), tuples.size());
  for (vtkIdType i = 0; i < tuples.size(); ++i)
  {
    ASSERT_EQ(result.Numbers[i], numbers[tuples[i]]) << "tuple " << i << ", leading " << leading;
  }
  EXPECT_EQ(ToVector(result.Representatives), representatives) << "leading " << leading;
}

template <int N, typename Id>
Tuples<N, Id> DrawTuples(Id vertices, vtkIdType size, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<Id> vertex(0, vertices - 1);
  Tuples<N, Id> tuples(size);
  for (auto& tuple : tuples)
  {
    std::set<Id> members;
    while (members.size() < N)
    {
      members.insert(vertex(random));
    }
    std::copy(members.begin(), members.end(), tuple.begin());
  }
  return tuples;
}

template <int N, typename Id>
void CheckRandomTuples()
{
  // Few vertices: most tuples come several times; many: groups of one tuple and empty groups.
  for (const Id vertices : { Id(6), Id(40), Id(3000) })
  {
    constexpr vtkIdType size = 700;
    std::vector<std::array<Id, N>> list;
    for (const auto& tuple : DrawTuples<N, Id>(vertices, size, N))
    {
      list.push_back(tuple);
    }
    const auto check = [&]()
    {
      const Tuples<N, Id> tuples = ToTuples<N, Id>(list);
      const vtkIdType all = tuples.size();
      for (const vtkIdType leading : { vtkIdType(0), vtkIdType(1), all / 3, all - 1, all })
      {
        CheckByDefinition<N, Id>(tuples, NumberTuples<N, Id>(tuples, vertices, leading), leading);
      }
    };
    check();
    std::sort(list.begin(), list.end()); // with the same tuple several times in a row
    check();
    list.erase(std::unique(list.begin(), list.end()), list.end());
    check();
  }
}

}

TEST(CoreTupleIndex, SortedTuplesBeginWithTheSmallest)
{
  const std::vector<int> vertices = { 7, 2, 9, 4, 0 };
  EXPECT_EQ((SortedTuple<4, int>(vertices.data())), (std::array<int, 4>{ 2, 4, 7, 9 }));
  EXPECT_EQ((SortedTuple<2, int>(vertices.data())), (std::array<int, 2>{ 2, 7 }));
}

TEST(CoreTupleIndex, NumbersFollowTheLeadingTuplesThenTheVertices)
{
  const auto tuples =
    ToTuples<2, int>({ { 1, 2 }, { 0, 1 }, { 1, 2 }, { 0, 3 }, { 0, 1 }, { 0, 2 } });
  const TupleNumbers<int> none = NumberTuples<2, int>(tuples, 4, 0);
  EXPECT_EQ(ToVector(none.Numbers), (std::vector<int>{ 3, 0, 3, 2, 0, 1 }));
  EXPECT_EQ(ToVector(none.Representatives), (std::vector<int>{ 1, 5, 3, 0 }));
  const TupleNumbers<int> two = NumberTuples<2, int>(tuples, 4, 2);
  EXPECT_EQ(ToVector(two.Numbers), (std::vector<int>{ 0, 1, 0, 3, 1, 2 }));
  EXPECT_EQ(ToVector(two.Representatives), (std::vector<int>{ 0, 1, 5, 3 }));
  // A leading tuple that was there before takes no number of its own.
  const TupleNumbers<int> all = NumberTuples<2, int>(tuples, 4, 6);
  EXPECT_EQ(ToVector(all.Numbers), (std::vector<int>{ 0, 1, 0, 2, 1, 3 }));
  EXPECT_EQ(ToVector(all.Representatives), (std::vector<int>{ 0, 1, 3, 5 }));
}

TEST(CoreTupleIndex, OfNoTuplesThereAreNoNumbers)
{
  for (const int vertices : { 0, 5 })
  {
    const TupleNumbers<int> result = NumberTuples<3, int>(Tuples<3, int>(0), vertices, 0);
    EXPECT_EQ(result.Numbers.size(), 0);
    EXPECT_EQ(result.Representatives.size(), 0);
  }
}

TEST(CoreTupleIndex, RandomTuplesAreNumberedByDefinition)
{
  CheckRandomTuples<2, int>();
  CheckRandomTuples<3, int>();
  CheckRandomTuples<4, int>();
  CheckRandomTuples<2, long long>();
  CheckRandomTuples<4, long long>();
}

TEST(CoreTupleIndex, ThreadsChangeNothing)
{
  // More vertices than one thread takes alone.
  constexpr int vertices = 5 * static_cast<int>(WorthThreads);
  constexpr vtkIdType size = 100000;
  const Tuples<2, int> tuples = DrawTuples<2, int>(vertices, size, 3);
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    const TupleNumbers<int> result = NumberTuples<2, int>(tuples, vertices, size / 2);
    vtkSMPTools::Initialize(0);
    CheckByDefinition<2, int>(tuples, result, size / 2);
  }
}
