// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchWeights.h
 * The weights that control points have at a place of a regular patch, with derivatives.
 */
#ifndef SubdivisionObjects_PatchWeights_h
#define SubdivisionObjects_PatchWeights_h

#include "Core/Operators/PatchPowers.h"
#include "Core/Surfaces/Places/RegularPatch.h"

#include <array>

namespace subdivision
{

/// Where a place is: on a line x goes from the first vertex of the edge to the second one. In a
/// face the corners are at (0, 0), (1, 0), then (0, 1), or (1, 1) and (0, 1).
using PlaceAt = std::array<double, 2>;

/// Sets the wanted PlaceParts for the control points of a regular patch. There is no derivative by
/// a third parameter.
void WeightControlPoints(PolynomialDomain domain, const PlaceAt& at,
  const PatchDirections& directions, PlaceDerivatives derivatives, PatchParts& parts);

/// Of the corners of a part that counts as flat: linear, or bilinear.
PatchParts WeightCorners(int corners, const PlaceAt& at, const PatchDirections& directions);

}

#endif
