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

/// The rule that a vertex or an edge follows: its dimension, or one of two others in dimension 3.
enum class Rule : unsigned char
{
  Corner = 0,     ///< d = 0: does not move
  Curve = 1,      ///< d = 1: cubic B-spline
  Surface = 2,    ///< d = 2: Loop, eq. 16
  Solid = 3,      ///< d = 3: eq. 17, 18
  Blend = 4,      ///< rule G-2: the weights of d = 3 with the relief ring
  RegularEdge = 5 ///< d = 3: the valence-4 direction of the box spline, eq. 15: edges;
                  ///< in tet/oct levels regular vertices and centres too
};

/// What non-manifold vertices and edges do (Mathematics 6). FollowDimension1..3 are for type 1,
/// FollowPart for type 2; where a choice does not exist for a type it means Blend.
enum class JointRule : unsigned char
{
  Blend,
  Sharp,
  FollowDimension1,
  FollowDimension2,
  FollowDimension3,
  FollowPart
};

/// Of a vertex in which so many creases meet or, if they do not decide, so many edges that became
/// sharp as joints (Mathematics 4, 6): a curve goes through it along two of them, else it stays.
/// Whatever else is a curve there, boundaries for instance, does not count.
constexpr Rule RuleOfCurves(std::size_t edges)
{
  return edges == 2 ? Rule::Curve : Rule::Corner;
}

}

#endif
