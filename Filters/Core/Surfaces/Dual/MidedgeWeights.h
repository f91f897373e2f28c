// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MidedgeWeights.h
 * Weights of the midedge scheme (Mathematics 12).
 */
#ifndef SubdivisionObjects_MidedgeWeights_h
#define SubdivisionObjects_MidedgeWeights_h

#include <array>

namespace subdivision
{

/// Of both ends of an edge.
inline constexpr std::array<double, 2> MidedgeMiddle{ 1. / 2., 1. / 2. };

}

#endif
