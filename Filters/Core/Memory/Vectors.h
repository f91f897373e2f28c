// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Vectors.h
 * Three coordinates, and their products.
 */
#ifndef SubdivisionObjects_Vectors_h
#define SubdivisionObjects_Vectors_h

#include <array>

namespace subdivision
{
namespace vectors
{

using Vector = std::array<double, 3>;

inline Vector Subtract(const double* a, const double* b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
inline Vector Subtract(const Vector& a, const Vector& b)
{
  return Subtract(a.data(), b.data());
}

inline Vector Scale(double factor, const Vector& a)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

}
}

#endif
