// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Masks.h
 * The weights of the rules (Mathematics 5). They follow from the rule and the size of the ring.
 * Sources include this, and no headers that others read, so that a changed weight compiles few
 * files again.
 */
#ifndef SubdivisionObjects_Masks_h
#define SubdivisionObjects_Masks_h

#include "Core/Rules/LoopWeights.h"
#include "Core/Rules/Mask.h"
#include "Core/Rules/Pi.h"
#include "Core/Rules/Rule.h"

#include <cmath>

namespace subdivision
{

/// The mask of a vertex with d = 2. Where both choices are equal, they have equal bits.
inline Mask SurfaceVertexMask(vtkIdType ringSize, LoopWeights weights)
{
  const double m = static_cast<double>(ringSize);
  if (ringSize == 3)
  {
    return { 7. / 16., 3. / 16. };
  }
  if (weights == LoopWeights::Warren || ringSize == 6)
  {
    return { 5. / 8., 3. / (8. * m) };
  }
  const double wave = 3. / 8. + std::cos(2. * Pi / m) / 4.;
  return { 3. / 8. + wave * wave, (5. / 8. - wave * wave) / m };
}

inline Mask VertexMask(Rule rule, vtkIdType ringSize, LoopWeights weights)
{
  const double m = static_cast<double>(ringSize);
  switch (rule)
  {
    case Rule::Curve:
      return { 3. / 4., 1. / 8. };
    case Rule::Surface:
      return SurfaceVertexMask(ringSize, weights);
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
