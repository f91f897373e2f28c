// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedDirectory.h
 * The directory of things that several partitions of a mesh have: it is spread over the partitions.
 */
#ifndef SubdivisionObjects_SharedDirectory_h
#define SubdivisionObjects_SharedDirectory_h

#include "Private/Partitions/OtherPartitions.h"

#include "vtkType.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// Things by which partitions know each other's points, edges and cells: a key of `Width` ids each,
/// none of them negative. Equal keys are one thing, and the lexicographic order of keys is the
/// order of the whole mesh.
struct SharedKeys
{
  int Width = 1;
  std::vector<vtkIdType> Keys;
  /// Of each thing, whether this partition is sure that it exists: it belongs to an own cell.
  std::vector<char> Own;
  /// How many ids of several kinds each thing gets: `Kinds` numbers for each. Empty: one of one
  /// kind.
  int Kinds = 1;
  std::vector<vtkIdType> Sizes;
};

/**
 * Whoever keeps a thing learns which partitions have it and the numbers that they tell of it, and
 * may answer each of them. All partitions make one, and call TakeAnswers, together: an exchange
 * each. 8 bytes are sent for each id of a key and each number that is told or answered.
 */
class SharedDirectory
{
public:
  /// The message of a partition about a thing.
  struct Entry
  {
    const vtkIdType* Key;
    const vtkIdType* Told;
    vtkIdType* Answer; ///< -1 each, until they are set
    int From;
    bool IsOwn;
  };

  /// `told`: so many numbers of each thing go to its keeper; `answers`: so many come back. Nobody
  /// keeps a thing whose first id is negative.
  SharedDirectory(const SharedKeys& things, int told, const std::vector<vtkIdType>& numbers,
    int answers, Exchange& exchange);
  SharedDirectory(const SharedDirectory&) = delete;
  SharedDirectory& operator=(const SharedDirectory&) = delete;

  /// act(first, last): the entries of each thing that this partition keeps, by the number of the
  /// partition; things in the order of their keys.
  template <typename Act>
  void ForThings(const Act& act)
  {
    for (auto first = this->Entries.begin(); first != this->Entries.end();)
    {
      const auto last = std::find_if(first, this->Entries.end(), [&](const Entry& entry)
        { return !std::equal(entry.Key, entry.Key + this->Width, first->Key); });
      act(first, last);
      first = last;
    }
  }
  /// The answers of the keepers, for each thing of this partition; -1 where nobody answered.
  std::vector<vtkIdType> TakeAnswers();

private:
  using ListsOfIds = Exchange::Lists<vtkIdType>; ///< of each partition

  Exchange& With;
  int Width;
  int Answers;
  std::size_t Size;   ///< how many things this partition has
  ListsOfIds Places;  ///< of the things that each keeper has, in the order of messages
  ListsOfIds Arrived; ///< the messages of partitions
  ListsOfIds Replies;
  std::vector<Entry> Entries;
};

}

#endif
