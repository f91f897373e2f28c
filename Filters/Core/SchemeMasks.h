// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SchemeMasks.h
 * The weights of the surface schemes that are neither Loop's nor Catmull and Clark's (SPEC 11, 12):
 * one function for each mask, its source beside it.
 *
 * Kobbelt: "sqrt(3)-subdivision"; Zorin: "Subdivision on arbitrary meshes". k is the number of
 * faces around a vertex, or between two neighbouring sharp edges at it (its *sector*).
 */
#ifndef SubdivisionObjects_SchemeMasks_h
#define SubdivisionObjects_SchemeMasks_h

#include <cmath>

namespace subdivision
{

constexpr double Pi = 3.14159265358979323846;

// ------------------------------------------------------------------------------------------------
// sqrt(3)

/// The weight of the mean of the n neighbours of an interior vertex (Kobbelt, eq. 6).
inline double SqrtThreeRing(int n)
{
  return (4. - 2. * std::cos(2. * Pi / n)) / 9.;
}

/// The weight of that mean in the limit position (Kobbelt, eq. 7 for m to infinity).
inline double SqrtThreeLimitRing(int n)
{
  const double a = SqrtThreeRing(n);
  return 3. * a / (1. + 3. * a);
}

/// How much of p - limit is left after m steps (Kobbelt, eq. 8).
inline double SqrtThreeDecay(int n, int m)
{
  return std::pow(2. / 3. - SqrtThreeRing(n), m);
}

/// The cubic B-spline in thirds (Kobbelt, eq. 9): a point of the curve and its two neighbours; and
/// the point one third along an edge, from the neighbour before its nearer end to its farther end.
constexpr double CurveThirdVertex[3] = { 4. / 27., 19. / 27., 4. / 27. };
constexpr double CurveThirdEdge[3] = { 1. / 27., 16. / 27., 10. / 27. };
/// Next to a corner or to the end of the curve: nearer end, farther end.
constexpr double CornerThirdEdge[2] = { 2. / 3., 1. / 3. };

// ------------------------------------------------------------------------------------------------
// Modified Butterfly

/// Regular edge: each end, each opposite vertex, each of the four wings (Zorin, figure 7).
constexpr double ButterflyEnd = 1. / 2.;
constexpr double ButterflyOpposite = 1. / 8.;
constexpr double ButterflyWing = -1. / 16.;

/// Boundary and crease: each end, each point beyond (Zorin, section 4: the four-point scheme).
constexpr double FourPointEnd = 9. / 16.;
constexpr double FourPointBeyond = -1. / 16.;

/// Edge at an extraordinary interior vertex: the weight of neighbour j, counted from the edge
/// (Zorin, figure 7). The vertex itself has 3/4. Two neighbours (not in the survey): constants and
/// linear functions along the edge.
inline double ButterflyRing(int k, int j)
{
  constexpr double two[2] = { 3. / 8., -1. / 8. };
  constexpr double three[3] = { 5. / 12., -1. / 12., -1. / 12. };
  constexpr double four[4] = { 3. / 8., 0., -1. / 8., 0. };
  switch (k)
  {
    case 1:
      return 1. / 4.;
    case 2:
      return two[j];
    case 3:
      return three[j];
    case 4:
      return four[j];
    default:
      return (1. / 4. + std::cos(2. * Pi * j / k) + std::cos(4. * Pi * j / k) / 2.) / k;
  }
}
constexpr double ButterflyCentre = 3. / 4.;

/// Edge i = 1..k-1 of a sector of k triangles at a smooth boundary or crease vertex: the weight of
/// neighbour j = 0..k (Zorin, section 4: c_ij).
inline double ButterflySectorRing(int k, int i, int j)
{
  const double t = Pi / k;
  if (j == 0 || j == k)
  {
    const double end = std::cos(i * t) / 4. -
      std::sin(2. * t) * std::sin(2. * i * t) / (4. * k * (std::cos(t) - std::cos(2. * t)));
    return j == 0 ? end : -end;
  }
  return (std::sin(i * t) * std::sin(j * t) + std::sin(2. * i * t) * std::sin(2. * j * t) / 2.) / k;
}

/// The weight of the vertex itself (c_0).
inline double ButterflySectorCentre(int k, int i)
{
  const double t = Pi / k;
  return 1. - std::sin(t) * std::sin(i * t) / (k * (1. - std::cos(t)));
}

/// The same for a sector of angle alpha at a corner. The survey has no rule for it; this one has
/// its precision: functions linear in the sector are halved, the first mode that vanishes at both
/// sharp edges is quartered, and nothing else is left.
inline double ButterflyCornerRing(int k, double alpha, int i, int j)
{
  const double t = alpha / k;
  auto mode = [k](int m) { return std::sin(m * Pi / k); };
  // What the two sharp edges say of neighbour i, and how much of the mode that contains.
  auto linear = [&](int m, int end)
  { return std::sin((end == 0 ? k - m : m) * t) / std::sin(alpha); };
  if (j > 0 && j < k)
  {
    return mode(i) * mode(j) / (2. * k);
  }
  double inMode = 0.;
  for (int m = 1; m < k; ++m)
  {
    inMode += mode(m) * linear(m, j);
  }
  return linear(i, j) / 2. - mode(i) * inMode / (2. * k);
}

/// Regular interior vertex v, regular crease vertex w (SPEC 12).
namespace interiorcrease
{
constexpr double Interior = 5. / 8.;
constexpr double Crease = 3. / 8.;
constexpr double OppositeInside = 3. / 16.;
constexpr double OppositeOnCrease = 1. / 16.;
constexpr double WingInteriorInside = -1. / 8.; ///< across the edge from v to the opposite inside
constexpr double OtherWing = -1. / 16.;
}

/// Two regular crease vertices whose missing wings are on the same side (SPEC 12).
namespace creasecrease
{
constexpr double End = 1. / 2.;
constexpr double Opposite = 1. / 4.; ///< the other side
constexpr double Wing = -1. / 8.;    ///< the two on the other side
}

// ------------------------------------------------------------------------------------------------
// Dual schemes

/// The new vertex at a corner of a face with k corners: the weight of corner j, counted from it
/// (Zorin, figure 9).
inline double DooSabinCorner(int k, int j)
{
  return j == 0 ? 1. / 4. + 5. / (4. * k) : (3. + 2. * std::cos(2. * Pi * j / k)) / (4. * k);
}

/// A boundary edge is a quad whose long sides coincide: its two points (Zorin, section 4.1).
constexpr double DooSabinBoundary[2] = { 3. / 4., 1. / 4. };

// ------------------------------------------------------------------------------------------------
// 4-8

/// Old vertex: itself, and the mean of its neighbours (Zorin, figure 10).
constexpr double FourEightVertex = 1. / 2.;
constexpr double FourEightRing = 1. / 2.;

/// Curves in even steps: a vertex and its two neighbours; new points are midpoints.
constexpr double FourEightCurve[2] = { 3. / 4., 1. / 8. };

}

#endif
