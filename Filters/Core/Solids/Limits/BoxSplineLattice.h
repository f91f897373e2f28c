// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxSplineLattice.h
 * The vertices of all levels of a box-spline refinement and their rows, without making a level.
 *
 * A vertex of the level after k steps lies in a simplex of the control level and has weights of its
 * corners that are multiples of 1/2^k. Steps only split along directions of edges and of the
 * diagonals of tetrahedra, so that the neighbours of a vertex, and with them its row, follow from
 * these numbers and from the rings of the control level.
 */
#ifndef SubdivisionObjects_BoxSplineLattice_h
#define SubdivisionObjects_BoxSplineLattice_h

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/LimitRowMaker.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Scheme/Level.h"

#include <array>
#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace subdivision
{

using LatticeWeights = std::array<long long, 4>;

template <typename Id>
struct LatticeVertex
{
  int Dimension = 0; ///< of the simplex of the control level inside of which it lies
  Id Simplex = 0;    ///< vertex, edge, face or tetrahedron
  /// Of the corners of the simplex, as the complex lists them, in multiples of 1/2^level. All that
  /// the simplex has are positive.
  LatticeWeights Weights{};

  bool operator==(const LatticeVertex& other) const
  {
    return this->Dimension == other.Dimension && this->Simplex == other.Simplex &&
      this->Weights == other.Weights;
  }
  std::uint64_t GetHash() const
  {
    std::uint64_t hash =
      4 * static_cast<std::uint64_t>(this->Simplex) + static_cast<std::uint64_t>(this->Dimension);
    for (const long long weight : this->Weights)
    {
      hash = (hash ^ static_cast<std::uint64_t>(weight)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return hash;
  }
  /// On the control level its number.
  Id GetColumn() const { return this->Simplex; }
  /// The same vertex as one of the next level.
  LatticeVertex Double() const
  {
    LatticeVertex vertex = *this;
    for (long long& weight : vertex.Weights)
    {
      weight *= 2;
    }
    return vertex;
  }
};

template <typename Id>
using LatticeRow = VertexRow<LatticeVertex<Id>>;

/// The weights of limits, or of stars, which equal neighbourhoods share.
class LatticeLimits
{
public:
  /// `most` are kept, which bounds the memory.
  explicit LatticeLimits(std::size_t most = 4096)
    : Most(most)
  {
  }
  /// solve(weights) finds those that are not known yet; null where it returns false.
  template <typename Solve>
  const std::vector<double>* Find(const Neighbourhood& key, const Solve& solve)
  {
    if (this->Weights.size() > this->Most)
    {
      this->Weights.clear();
    }
    std::vector<double>& weights = this->Weights[key];
    return !weights.empty() || solve(weights) ? &weights : nullptr;
  }

private:
  const std::size_t Most;
  std::unordered_map<Neighbourhood, std::vector<double>, HashNeighbourhood> Weights;
};

/// Appends a number that need not fit into an int.
template <typename Id>
void AppendId(Id id, Neighbourhood& key)
{
  const auto number = static_cast<std::uint64_t>(id);
  key.insert(key.end(), { static_cast<int>(number), static_cast<int>(number >> 32) });
}

/// What the limit of a vertex depends on: the vertex itself and its neighbours, and what a step
/// makes of them, which are the same ones on the next level. Some may be there twice.
template <typename Id>
struct LatticeStar
{
  std::vector<LatticeVertex<Id>> Items;
  std::vector<LatticeVertex<Id>> Next;

  void Add(const LatticeVertex<Id>& item, const LatticeVertex<Id>& next)
  {
    this->Items.push_back(item);
    this->Next.push_back(next);
  }
};

/// It has all rules; of a level of another scheme than the box spline those with d < 3, and with
/// Blend what does not lie inside solids. Methods return false where the rule is that of solids
/// there. Nothing is semi-sharp (SharpLattice.h). Nobody may ask for limits of vertices of the
/// control level itself, whose first step may differ. Threads have one each.
template <typename Id>
class BoxSplineLattice
{
public:
  using LevelRow = LatticeRow<Id>;

  /// `level` was made with Depth::ForRefinement, or is the control level; `strata`: its own, or
  /// those of a SharpStage. Both must outlive this.
  template <typename LevelType>
  BoxSplineLattice(const LevelType& level, const subdivision::Strata<Id>& strata)
    : Complex(level.Complex)
    , Strata(strata)
    , HasSolids(std::is_same<LevelType, Level<Id>>::value)
  {
  }

  /// The vertex with some weights of the corners of a simplex, none of which is negative.
  LatticeVertex<Id> Find(int dimension, Id simplex, const LatticeWeights& weights) const;
  /// Weights of corners of a tetrahedron as those of another one, which has all corners whose
  /// weight is not 0.
  LatticeWeights LiftToTet(Id tet, const LatticeWeights& weights, Id other) const
  {
    return this->Lift(this->GetCorners(3, tet), 4, weights, this->GetCorners(3, other), 4);
  }

  /// The row of a vertex over the level before it.
  bool ReadRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const;
  /// The limit of a vertex over its own level (Mathematics 8).
  bool ReadLimit(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row);
  /// Adds a vertex and its ring.
  bool AddStar(const LatticeVertex<Id>& vertex, LatticeStar<Id>& star) const;
  /// Adds the neighbours of a vertex, which is no control vertex, in a tetrahedron at it, whatever
  /// its rule reads.
  void AddStarInSolid(const LatticeVertex<Id>& vertex, Id tet, LatticeStar<Id>& star) const;

  Rule GetRule(const LatticeVertex<Id>& vertex) const;
  /// The vertices of an edge, face or tetrahedron.
  const Id* GetCorners(int dimension, Id simplex) const;

private:
  LatticeWeights Lift(const Id* from, int corners, const LatticeWeights& weights, const Id* to,
    int cornersThere) const;
  bool IsUnknown(Rule rule) const { return !this->HasSolids && rule == Rule::Solid; }
  template <typename Act>
  bool ForRing(const LatticeVertex<Id>& vertex, const Act& act) const;
  template <typename Act>
  bool ForRingOfVertex(const LatticeVertex<Id>& vertex, const Act& act) const;
  template <typename Act>
  bool ForRingOnEdge(const LatticeVertex<Id>& vertex, const Act& act) const;
  template <typename Act>
  bool ForRingInFace(const LatticeVertex<Id>& vertex, const Act& act) const;
  template <typename Act>
  bool ForRingInTet(const LatticeVertex<Id>& vertex, const Act& act) const;
  bool ReadVertexRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const;
  bool ReadEdgeRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const;
  bool ApplySectors(
    const LatticeVertex<Id>& vertex, const LatticeWeights& base, LatticeRow<Id>& row) const;
  bool AddRingOfEdge(
    const LatticeVertex<Id>& vertex, const LatticeWeights& base, LatticeRow<Id>& row) const;
  bool AddRingInFace(const LatticeVertex<Id>& vertex, const LatticeWeights& base,
    LatticeRow<Id>& row, Rule& rule) const;
  void AddRingInTet(const LatticeVertex<Id>& vertex, const LatticeWeights& base,
    LatticeRow<Id>& row, Rule& rule) const;
  void SetKey(const LatticeVertex<Id>& vertex);
  void AppendEdge(Id edge);

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const bool HasSolids; ///< of the box-spline scheme
  LatticeLimits Limits;
  // Of the limit that is looked for:
  Neighbourhood Key;
  std::vector<Id> Tets;
};

}

#endif
