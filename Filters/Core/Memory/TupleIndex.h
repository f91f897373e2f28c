// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TupleIndex.h
 * Numbers sets of vertices, equal sets alike, whatever their size. Edges and faces of cells are
 * found by PairIndex.h, which takes less time.
 */
#ifndef SubdivisionObjects_TupleIndex_h
#define SubdivisionObjects_TupleIndex_h

#include "Core/Memory/Buffer.h"

#include <array>

namespace subdivision
{

/// A vertex set of N members, smallest first.
template <int N, typename Id>
std::array<Id, N> SortedTuple(const Id* vertices)
{
  std::array<Id, N> tuple;
  std::copy(vertices, vertices + N, tuple.begin());
  for (int end = N - 1; end > 0; --end) // a few comparisons without branches
  {
    for (int k = 0; k < end; ++k)
    {
      const Id less = std::min(tuple[k], tuple[k + 1]);
      tuple[k + 1] = std::max(tuple[k], tuple[k + 1]);
      tuple[k] = less;
    }
  }
  return tuple;
}

/// Compares two sets of vertices with the same smallest one: negative, 0 or positive.
template <int N, typename Id>
Id CompareTails(const std::array<Id, N>& a, const std::array<Id, N>& b)
{
  for (int k = 1; k + 1 < N; ++k)
  {
    if (a[k] != b[k])
    {
      return a[k] - b[k];
    }
  }
  return a[N - 1] - b[N - 1];
}

template <typename Id>
struct TupleNumbers
{
  Buffer<Id> Numbers;         ///< the number of each tuple
  Buffer<Id> Representatives; ///< the first tuple that has each number
};

/// Whether each tuple comes after the one before in lexicographic order, so that all are different.
template <int N, typename Id>
bool AreAscending(const Buffer<std::array<Id, N>>& tuples)
{
  for (const vtkIdType i : InTurn(tuples.size() - 1))
  {
    const Id order = tuples[i + 1][0] != tuples[i][0] ? tuples[i + 1][0] - tuples[i][0]
                                                      : CompareTails<N>(tuples[i + 1], tuples[i]);
    if (order <= 0)
    {
      return false;
    }
  }
  return true;
}

/**
 * Numbers the distinct tuples: first the tuples that occur among the first `leading` ones, in the
 * order of their first occurrence; then all others in lexicographic order. Tuples are grouped by
 * their smallest vertex. Threads sort the groups, and the result does not depend on their number.
 */
template <int N, typename Id>
TupleNumbers<Id> NumberTuples(
  const Buffer<std::array<Id, N>>& tuples, Id numberOfVertices, vtkIdType leading)
{
  const vtkIdType size = tuples.size();
  if (AreAscending<N>(tuples))
  {
    TupleNumbers<Id> all{ Buffer<Id>(size), Buffer<Id>(size) };
    ForEach(
      size, [&](vtkIdType i) { all.Numbers[i] = all.Representatives[i] = static_cast<Id>(i); });
    return all;
  }
  Rows<Id> groups = ListByRow<Id>(
    numberOfVertices, size, [&](vtkIdType i) { return tuples[i][0]; },
    [](vtkIdType i) { return static_cast<Id>(i); });
  const Buffer<Id>& starts = groups.Offsets;
  Buffer<Id>& grouped = groups.Items;
  // Sort each group; let every tuple know the first one that equals it.
  TupleNumbers<Id> result;
  Buffer<Id> first(size);
  Buffer<Id> newcomers(numberOfVertices + 1, Id(0)); // new tuples of a group beyond `leading`
  ForEach(numberOfVertices,
    [&](vtkIdType v)
    {
      Id* begin = grouped.data() + starts[v];
      Id* end = grouped.data() + starts[v + 1];
      std::sort(begin, end,
        [&](Id a, Id b)
        {
          const Id order = CompareTails<N>(tuples[a], tuples[b]);
          return order != 0 ? order < 0 : a < b;
        });
      Id count = 0;
      for (Id* i = begin; i != end; ++i)
      {
        const bool isFirst = i == begin || CompareTails<N>(tuples[*i], tuples[*(i - 1)]) != 0;
        first[*i] = isFirst ? *i : first[*(i - 1)];
        count += isFirst && *i >= leading ? 1 : 0;
      }
      newcomers[v] = count;
    });
  CountsToOffsets(newcomers);
  result.Numbers = Buffer<Id>(size);
  Id leaders = 0;
  ForEachInTurn(leading,
    [&](vtkIdType i) { result.Numbers[i] = first[i] == i ? leaders++ : result.Numbers[first[i]]; });
  result.Representatives = Buffer<Id>(leaders + newcomers[numberOfVertices]);
  ForEach(leading,
    [&](vtkIdType i)
    {
      if (first[i] == i)
      {
        result.Representatives[result.Numbers[i]] = static_cast<Id>(i);
      }
    });
  ForEach(numberOfVertices,
    [&](vtkIdType v)
    {
      Id number = leaders + newcomers[v];
      for (Id k = starts[v]; k < starts[v + 1]; ++k)
      {
        const Id i = grouped[k];
        if (i < leading)
        {
          continue;
        }
        if (first[i] == i)
        {
          result.Representatives[number] = i;
          result.Numbers[i] = number++;
        }
        else
        {
          result.Numbers[i] = result.Numbers[first[i]];
        }
      }
    });
  return result;
}

}

#endif
