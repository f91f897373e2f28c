// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenFew.h
 * Red-green refinement of a few cells that a test writes down by hand.
 */
#ifndef SubdivisionObjects_RedGreenFew_h
#define SubdivisionObjects_RedGreenFew_h

#include "RedGreenReference.h"

namespace redgreen_reference
{

SimplexList MakeList(vtkIdType points, const std::vector<Tuple>& cells);

/// A state of a few cells.
struct Few
{
  Few(vtkIdType points, const std::vector<Tuple>& cells);
  /// How many cells of each kind the output has: untouched, red, green-I, green-II, green-III.
  std::vector<int> Count();
  /// The vertex in the middle of two, -1.
  int FindMiddle(int a, int b) const;
  /// How many cells are stored. The last cell must be a triangle that touches no other one and was
  /// not marked: its children get the next ids. Nothing may be done with the state afterwards.
  int CountStored();

  SimplexList List;
  RedGreen<int> State;
  std::vector<double> Points;
};

using Counts = std::vector<int>;

/// How often edges were halved until there was a vertex.
int CountHalvings(const RedGreen<int>& state, int vertex);

}

#endif
