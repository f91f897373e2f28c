// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Masks.h
 * The weights of the rules (Mathematics 5). A mask has two weights: one for the vertex itself, or
 * for each of the two ends of an edge, and one for each member of the ring. Both follow from the
 * rule and the size of the ring.
 */
#ifndef SubdivisionObjects_Masks_h
#define SubdivisionObjects_Masks_h

#include "Core/Rules/Rule.h"

#include "vtkType.h"

namespace subdivision
{

struct Mask
{
  double Own;
  double Ring;
};

/// A mask for a ring that consists of up to three sections, each with a size and a weight of its
/// own.
struct PartedMask
{
  double Own;
  int Parts;
  vtkIdType Sizes[3];
  double Weights[3];
};

/// The same mask for a ring of one section.
inline PartedMask MakeParted(const Mask& mask, vtkIdType ringSize)
{
  return { mask.Own, 1, { ringSize, 0, 0 }, { mask.Ring, 0., 0. } };
}

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
