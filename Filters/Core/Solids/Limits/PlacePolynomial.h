// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlacePolynomial.h
 * The polynomial of degree 4 over a simplex that has given values where its edges are divided in
 * four, and how a simplex is split.
 */
#ifndef SubdivisionObjects_PlacePolynomial_h
#define SubdivisionObjects_PlacePolynomial_h

#include "Core/Solids/Limits/PlaceLimits.h"

#include <array>
#include <vector>

namespace subdivision
{

/// Four numbers, one for each corner of a simplex.
using CornerWeights = std::array<double, 4>;
using CornerMatrix = std::array<CornerWeights, 4>;

/// A node of the polynomial: multiples of 1/4 for each corner.
using PlaceNode = std::array<int, 4>;
constexpr int LatticeSize = 4;

/// All nodes of a simplex: 5, 15 or 35; 1 for a vertex.
const std::vector<PlaceNode>& ListLattice(int dimension);

/// The weights of the nodes for each of PlaceParts at a point with the weights `at` of the corners.
/// `directions`: how these change with the parameters.
std::vector<std::array<double, PlaceParts::Count>> WeightLattice(
  int dimension, const CornerWeights& at, const std::array<CornerWeights, 3>& directions);

/// A child of a simplex.
struct SimplexChild
{
  /// The corners of the simplex in the middle of which each corner of the child is. Where it is a
  /// corner itself, both are the same.
  std::array<std::array<int, 2>, 4> Corners;
  CornerMatrix ToChild; ///< from the weights of the corners of the simplex
};
const std::vector<SimplexChild>& ListChildren(int dimension);

CornerWeights Multiply(const CornerMatrix& matrix, const CornerWeights& weights);

/// The numbers of the children that lead from a simplex to a part of it (SheetKey::Part).
std::vector<int> ListChildrenTo(int part);

/// A place in a part of its simplex.
struct PlaceInPart
{
  /// The corners of the simplex between which each corner of the part lies, as bits.
  std::array<int, 4> Carriers{ { 1, 2, 4, 8 } };
  CornerWeights At{};                        ///< the place
  std::array<CornerWeights, 3> Directions{}; ///< how it changes with the parameters

  void GoToChild(int dimension, int child);
  /// The child with the place.
  int FindChild(int dimension) const;
  /// A place that rounding has put beside a face goes on the face. Each split would double the
  /// distance, and beside what is never regular there are many.
  void MoveInside();
};

template <typename Id>
PlaceInPart StartPart(const LimitPlace<Id>& place)
{
  PlaceInPart part;
  const int first = place.Order[0];
  part.At[first] = 1.;
  for (int k = 1; k <= place.Dimension; ++k)
  {
    const int corner = place.Order[k];
    part.At[corner] += place.Parameters[k - 1];
    part.At[first] -= place.Parameters[k - 1];
    part.Directions[k - 1][corner] = 1.;
    part.Directions[k - 1][first] = -1.;
  }
  part.MoveInside();
  return part;
}

inline PlaceInPart GoToPart(int dimension, PlaceInPart place, int part)
{
  for (const int child : ListChildrenTo(part))
  {
    place.GoToChild(dimension, child);
  }
  return place;
}

}

#endif
