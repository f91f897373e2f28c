// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pi.h
 * The number that C++17 has no name for.
 */
#ifndef SubdivisionObjects_Pi_h
#define SubdivisionObjects_Pi_h

namespace subdivision
{

constexpr double Pi = 3.14159265358979323846;

}

#endif
