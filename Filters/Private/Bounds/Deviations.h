// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Deviations.h
 * How far steps move points away from the middles of old ones, and what bound on the distance from
 * the limit follows (Mathematics 14).
 */
#ifndef SubdivisionObjects_Deviations_h
#define SubdivisionObjects_Deviations_h

#include "Core/Memory/Buffer.h"
#include "Private/Bounds/NestedPieces.h"
#include "Private/Bounds/Sectors.h"

#include <functional>

namespace subdivision
{

/// Values of one array at the points of an output, and after one further step.
struct BoundedValues
{
  int Components;
  const double* Shown;        ///< of the output
  const Buffer<double>& Next; ///< control values after one step
  /// Applies step 2 or 3.
  std::function<Buffer<double>(int step, const Buffer<double>& values)> Step;
  double Rounding; ///< what all bounds are increased by
};

/// Sets the bound of each cell; infinity where values are not finite.
void FindBounds(
  const NestedPieces& pieces, const Sectors& sectors, const BoundedValues& values, double* bounds);

}

#endif
