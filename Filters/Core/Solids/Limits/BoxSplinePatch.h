// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxSplinePatch.h
 * The limit over a tetrahedron of the regular lattice: a polynomial of degree 5, as weights of the
 * 32 vertices at the tetrahedron and beside it.
 *
 * The box spline has the four directions p, q, r and -(p + q + r) of the lattice, each twice. Each
 * pair makes a hat function of one variable, so that the box spline at x p + y q + z r is
 * the integral over s of hat(x + s) hat(y + s) hat(z + s) hat(s). Between the places where one of
 * these numbers is an integer a rule of Gauss with three points is exact.
 */
#ifndef SubdivisionObjects_BoxSplinePatch_h
#define SubdivisionObjects_BoxSplinePatch_h

#include "Core/Operators/PlaceParts.h"
#include "Core/Solids/Limits/PlacePolynomial.h"

#include <array>
#include <vector>

namespace subdivision
{

struct BoxSplineNode
{
  /// From corner 0: multiples of the ways from corner 0 to 1, 1 to 2 and 2 to 3.
  std::array<int, 3> Steps{};
  std::array<double, PlaceParts::Count> Weights{};
};

/// `at` and `directions`: the weights of the corners of a place, and how they change with the
/// parameters. Nodes whose weights are all 0 are left out.
std::vector<BoxSplineNode> WeightBoxSpline(
  const CornerWeights& at, const std::array<CornerWeights, 3>& directions);

}

#endif
