// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeRings.h
 * The rows of the vertices of a lattice (BoxSplineLattice.h) in the order that they have on levels,
 * so that sums round alike.
 */
#ifndef SubdivisionObjects_LatticeRings_h
#define SubdivisionObjects_LatticeRings_h

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/Limits/LatticeRing.h"

#include <unordered_map>

namespace subdivision
{

/// It has no rule of sectors, and nothing is semi-sharp. Methods that return false have met a rule
/// that they do not know, such as a joint that is sharp.
template <typename Id>
class LatticeRings
{
public:
  /// `level` is the control level, and must outlive this.
  explicit LatticeRings(const Level<Id>& level)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Masks(BoxSplineMasks(level.Strata.Weights))
    , Lattice(level, this->NothingSharp, true)
  {
  }

  /// The row of a vertex over the level before it.
  bool ReadRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row);
  /// The limit of a vertex over its own level, which is not the control level.
  bool ReadLimit(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row);

private:
  LatticeRing* FindRing(const LatticeVertex<Id>& vertex);
  bool IsKnown(int dimension, Id simplex) const;
  Row<Id> GetCarriers(int dimension, Id simplex) const;
  void FindCut(const LatticeVertex<Id>& vertex);
  LatticeRing::Chart GetChart(int dimension, Id simplex, int size, const Id* corners) const;
  void MakeAtVertex(Id vertex, LatticeRing& ring) const;
  void MakeOnEdge(Id edge, LatticeRing& ring) const;
  LatticeVertex<Id> Go(const LatticeVertex<Id>& vertex, const LatticeRing& ring,
    const LatticeRing::Step& step, int factor, int divisor) const;
  void SetWeights(bool isEdge, Rule rule, LatticeRow<Id>& row) const;
  bool ReadEdgeRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row);
  bool SolveLimit(
    const LatticeVertex<Id>& vertex, const LatticeRing& ring, std::vector<double>& weights);

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const RingMasks& Masks;
  const SharpSimplices<Id> NothingSharp;
  const BoxSplineLattice<Id> Lattice; ///< for the names of vertices
  std::unordered_map<Neighbourhood, LatticeRing, HashNeighbourhood> Rings;
  // Of the ring that is looked for:
  Neighbourhood Key;
  std::vector<LatticeRing::Chart> Charts;
  LatticeCut Cut;
};

}

#endif
