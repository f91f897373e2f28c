// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Mask.h
 * The weights of one row. Masks.h has the weights of the rules.
 */
#ifndef SubdivisionObjects_Mask_h
#define SubdivisionObjects_Mask_h

#include "vtkType.h"

namespace subdivision
{

/// One weight for the vertex itself, or for each of the two ends of an edge, and one for each
/// member of the ring.
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

}

#endif
