// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointTools.h
 * Points in space as vectors.
 */
#ifndef SubdivisionObjects_PointTools_h
#define SubdivisionObjects_PointTools_h

#include "Precompiled.h"

namespace point_tools
{

using Point = std::array<double, 3>;

inline Point Subtract(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point Cross(const Point& a, const Point& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Point& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

inline double Distance(const Point& a, const Point& b)
{
  return Length(Subtract(a, b));
}

}

#endif
