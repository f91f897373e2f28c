// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sharpness.h
 * Of creases that are sharp for some levels: how many levels are left.
 */
#ifndef SubdivisionObjects_Sharpness_h
#define SubdivisionObjects_Sharpness_h

#include <algorithm>
#include <vector>

namespace subdivision
{

/// What is left of the sharpness of control edges: one value for each, 0 where there is none.
using EdgeSharpness = std::vector<double>;

/// Whether any edge is still sharp `steps` steps on.
inline bool IsSharpAfter(const EdgeSharpness& sharpness, int steps)
{
  return std::any_of(sharpness.begin(), sharpness.end(), [steps](double s) { return s > steps; });
}

}

#endif
