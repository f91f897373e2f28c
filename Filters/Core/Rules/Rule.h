// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Rule.h
 * The rules that vertices and edges follow, in solids and in surfaces (Mathematics 4, 6).
 */
#ifndef SubdivisionObjects_Rule_h
#define SubdivisionObjects_Rule_h

#include <cstddef>

namespace subdivision
{

/// The rule that a vertex or an edge follows. Values 0 to 3 are the dimension d; the other two are
/// special rules of dimension 3.
enum class Rule : unsigned char
{
  Corner = 0,     ///< d = 0: does not move
  Curve = 1,      ///< d = 1: cubic B-spline
  Surface = 2,    ///< d = 2: Loop, eq. 16
  Solid = 3,      ///< d = 3: eq. 17, 18
  Blend = 4,      ///< rule G-2: the weights of d = 3 with the relief ring
  RegularEdge = 5 ///< d = 3: an edge of the box spline in the direction of valence 4, eq. 15; in
                  ///< tet/oct levels also any regular edge, vertex or centre
};

/// The user's choice for non-manifold vertices and edges (Mathematics 6). FollowDimension1 to
/// FollowDimension3 exist for type 1, FollowPart for type 2. A choice that does not exist for a
/// type means Blend.
enum class JointRule : unsigned char
{
  Blend,
  Sharp,
  FollowDimension1,
  FollowDimension2,
  FollowDimension3,
  FollowPart
};

/// The rule of a vertex with `edges` creases, or, if creases do not decide, with `edges` edges that
/// the choice Sharp made sharp (Mathematics 4, 6). Two such edges form a curve through the vertex;
/// otherwise it is a corner. Other curves at the vertex, such as boundaries, do not count.
constexpr Rule RuleOfCurves(std::size_t edges)
{
  return edges == 2 ? Rule::Curve : Rule::Corner;
}

}

#endif
