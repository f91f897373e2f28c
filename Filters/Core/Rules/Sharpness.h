// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sharpness.h
 * The sharpness of semi-sharp creases: the number of steps for which they still are sharp.
 */
#ifndef SubdivisionObjects_Sharpness_h
#define SubdivisionObjects_Sharpness_h

#include <algorithm>
#include <vector>

namespace subdivision
{

/// The remaining sharpness of each control edge, 0 where the edge is no semi-sharp crease.
using EdgeSharpness = std::vector<double>;

/// Whether any edge is still sharp after `steps` more steps.
inline bool IsSharpAfter(const EdgeSharpness& sharpness, int steps)
{
  return std::any_of(sharpness.begin(), sharpness.end(), [steps](double s) { return s > steps; });
}

}

#endif
