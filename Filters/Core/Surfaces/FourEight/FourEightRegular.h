// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightRegular.h
 * Weights of rows of the 4-8 scheme that are made together (RegularGroups.h).
 */
#ifndef SubdivisionObjects_FourEightRegular_h
#define SubdivisionObjects_FourEightRegular_h

#include <array>

namespace subdivision
{

/// A smooth vertex and its four neighbours.
inline constexpr std::array<double, 5> FourEightVertex{ 1. / 2., 1. / 8., 1. / 8., 1. / 8.,
  1. / 8. };
/// The centre of a quad.
inline constexpr std::array<double, 4> FourEightCentre{ 1. / 4., 1. / 4., 1. / 4., 1. / 4. };

}

#endif
