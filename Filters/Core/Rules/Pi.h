// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pi.h
 * The number pi, for which the library of C++17 has no constant.
 */
#ifndef SubdivisionObjects_Pi_h
#define SubdivisionObjects_Pi_h

namespace subdivision
{

constexpr double Pi = 3.14159265358979323846;

}

#endif
