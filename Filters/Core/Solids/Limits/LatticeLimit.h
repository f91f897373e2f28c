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

/// The rows of a neighbourhood as ReadLocalRows reads them.
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

/// Adds to the star of a vertex of the control mesh what the rows of its items read besides: an
/// edge of the ring may have a rule that reads more than that of the vertex. `curved` knows
/// simplices. False: a rule is unknown.
template <typename Lattice, typename Id>
bool GrowStar(const Lattice& lattice, const BoxSplineLattice<Id>& curved, LatticeStar<Id>& star)
{
  VertexNumbers<LatticeVertex<Id>> known;
  for (const LatticeVertex<Id>& item : star.Items)
  {
    known.GetNumber(item);
  }
  const LatticeVertex<Id> centre = star.Items[0];
  LatticeRow<Id> row;
  bool isKnown = true;
  for (std::size_t i = 0; isKnown && i < star.Next.size(); ++i) // the list grows meanwhile
  {
    isKnown = lattice.ReadRow(star.Next[i], row);
    for (const LatticeVertex<Id>& vertex : row.Vertices)
    {
      if (known.Find(vertex) < 0)
      {
        known.GetNumber(vertex);
        const Id* corners = curved.GetCorners(vertex.Dimension, vertex.Simplex);
        const Id* end = corners + vertex.Dimension + 1;
        LatticeVertex<Id> next = vertex;
        next.Weights[std::find(corners, end, centre.Simplex) - corners] += centre.Weights[0];
        star.Add(vertex, next);
      }
    }
  }
  return isKnown;
}

/// Reads the rows of what a step makes of the items of a star; one that is there twice counts where
/// it comes first. False: a rule is unknown, or a row reads more than these.
template <typename Lattice, typename Id>
bool ReadStarRows(const Lattice& lattice, const LatticeStar<Id>& star, SolvedRows& rows)
{
  VertexNumbers<LatticeVertex<Id>> known;
  std::vector<int> places; // where each of these is among the items first
  for (std::size_t item = 0; item < star.Items.size(); ++item)
  {
    if (known.GetNumber(star.Items[item]) == places.size())
    {
      places.push_back(static_cast<int>(item));
    }
  }
  LatticeRow<Id> row;
  for (const LatticeVertex<Id>& next : star.Next)
  {
    if (!lattice.ReadRow(next, row))
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
      rows.Entries.emplace_back(places[static_cast<std::size_t>(number)], row.Weights[k]);
    }
    rows.EndRow();
  }
  return true;
}

/// Finds the weights of the items of a star in the limit. False: as in ReadStarRows.
template <typename Lattice, typename Id>
bool SolveLatticeLimit(
  const Lattice& lattice, const LatticeVertex<Id>& vertex, std::vector<double>& weights)
{
  LatticeStar<Id> star;
  SolvedRows rows;
  if (!lattice.AddStar(vertex, star) || !ReadStarRows(lattice, star, rows))
  {
    return false;
  }
  weights = ReadLocalRows(rows, Neighbourhood(), star.Items.size()).FindLimit();
  return true;
}

}

#endif
