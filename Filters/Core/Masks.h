// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Masks.h
 * The weights (SPEC 5). A mask has one weight for what is refined (a vertex, or each end of an
 * edge) and one for each member of its ring; which weights depends on the rule and the ring's size.
 */
#ifndef SubdivisionObjects_Masks_h
#define SubdivisionObjects_Masks_h

#include "vtkType.h"

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
  RegularEdge = 5 ///< d = 3: the valence-4 direction of the box spline, eq. 15; edges only
};

struct Mask
{
  double Own;
  double Ring;
};

inline Mask VertexMask(Rule rule, vtkIdType ringSize)
{
  const double m = static_cast<double>(ringSize);
  switch (rule)
  {
    case Rule::Curve:
      return { 3. / 4., 1. / 8. };
    case Rule::Surface: // eq. 16
      return ringSize == 3 ? Mask{ 7. / 16., 3. / 16. } : Mask{ 5. / 8., 3. / (8. * m) };
    case Rule::Solid: // eq. 17
    case Rule::Blend:
    case Rule::RegularEdge:
      return { 9. / 16., 7. / (16. * m) };
    default:
      return { 1., 0. };
  }
}

inline Mask EdgeMask(Rule rule, vtkIdType ringSize)
{
  if (ringSize == 0)
  {
    return { 1. / 2., 0. };
  }
  switch (rule)
  {
    case Rule::Surface:
      return { 3. / 8., 1. / 8. };
    case Rule::RegularEdge: // eq. 15
      return { 1. / 4., 1. / 8. };
    case Rule::Solid: // eq. 18
    case Rule::Blend:
      return { 5. / 16., 3. / (8. * static_cast<double>(ringSize)) };
    default:
      return { 1. / 2., 0. };
  }
}

}

#endif
