// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeLimit.h
 * Solves for the limit of a vertex of a lattice (BoxSplineLattice.h, TetOctLattice.h) by the rows
 * of its neighbourhood on the next level.
 */
#ifndef SubdivisionObjects_LatticeLimit_h
#define SubdivisionObjects_LatticeLimit_h

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"
#include "Core/Solids/Limits/LimitRowMaker.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace subdivision
{

/// The rows of a neighbourhood as SolveLimit reads them.
struct SolvedRows
{
  std::vector<std::size_t> Offsets{ 0 };
  std::vector<std::pair<int, double>> Entries;

  /// Ends a row, of which the order does not depend on how it was read.
  void EndRow()
  {
    std::sort(this->Entries.begin() + static_cast<std::ptrdiff_t>(this->Offsets.back()),
      this->Entries.end());
    this->Offsets.push_back(this->Entries.size());
  }
  template <typename Add>
  void Weigh(const int*&, int item, const Add& add) const
  {
    const std::size_t* row = this->Offsets.data() + item;
    for (std::size_t k = row[0]; k < row[1]; ++k)
    {
      add(this->Entries[k].first, this->Entries[k].second);
    }
  }
};

/// Finds the weights of `items`, the vertex and its neighbourhood; `next` is what they become on
/// the next level. False: a rule is unknown, or a row reads more than the neighbourhood.
template <typename Lattice, typename Id>
bool SolveLatticeLimit(Lattice& lattice, const std::vector<LatticeVertex<Id>>& items,
  const std::vector<LatticeVertex<Id>>& next, std::vector<double>& weights)
{
  VertexNumbers<LatticeVertex<Id>> known;
  std::vector<int> places; // where each of these is among the items first
  for (std::size_t item = 0; item < items.size(); ++item)
  {
    if (known.GetNumber(items[item]) == places.size())
    {
      places.push_back(static_cast<int>(item));
    }
  }
  SolvedRows solved;
  LatticeRow<Id> row;
  for (const LatticeVertex<Id>& vertex : next)
  {
    if (!lattice.ReadRow(vertex, row))
    {
      return false;
    }
    for (std::size_t k = 0; k < row.Vertices.size(); ++k)
    {
      const std::ptrdiff_t number = known.Find(row.Vertices[k]);
      if (number < 0)
      {
        return false;
      }
      solved.Entries.emplace_back(places[static_cast<std::size_t>(number)], row.Weights[k]);
    }
    solved.EndRow();
  }
  weights = SolveLimit(solved, Neighbourhood(), items.size());
  return true;
}

}

#endif
