// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedNumbers.h
 * Numbers what several partitions of a mesh have in the order in which the whole mesh has it.
 */
#ifndef SubdivisionObjects_SharedNumbers_h
#define SubdivisionObjects_SharedNumbers_h

#include "vtkType.h"

#include <array>
#include <vector>

namespace subdivision
{

class Partners;

/// Things by which partitions know each other's points, edges and cells: a key of `Width` ids each,
/// none of them negative. Equal keys are one thing, and the lexicographic order of keys is that of
/// the whole mesh.
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

struct SharedNumbers
{
  /// The number of ids before each thing in the whole mesh: `Kinds` of them; -1 where no partition
  /// is sure that it exists.
  std::vector<vtkIdType> First;
  std::vector<vtkIdType> Totals; ///< of each kind
};

/**
 * Numbers the things of all partitions, which call this together. A directory, spread over the
 * partitions by the first id of the key, sorts what they send and answers: two exchanges, about 8
 * (Width + Kinds) bytes there and 8 Kinds bytes back for each thing.
 */
SharedNumbers NumberTogether(const SharedKeys& things, Partners& partners);

}

#endif
