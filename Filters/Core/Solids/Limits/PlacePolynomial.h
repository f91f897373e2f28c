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

/// A child of a simplex: its corners as lattice points (Simplices.h), and the matrix that turns
/// weights of the corners of the simplex into those of the child.
struct SimplexChild
{
  std::array<int, 4> Corners;
  CornerMatrix ToChild;
};
const std::vector<SimplexChild>& ListChildren(int dimension);

/// The ends of an edge of a simplex.
const int* GetEdgeEnds(int dimension, int edge);

CornerWeights Multiply(const CornerMatrix& matrix, const CornerWeights& weights);

}

#endif
