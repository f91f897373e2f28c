// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SectorMasks.h
 * The weights of the modified rules next to boundaries, creases and corners (Mathematics 12), which
 * follow from the number of faces of a *sector*, and at a corner from its angle.
 */
#ifndef SubdivisionObjects_SectorMasks_h
#define SubdivisionObjects_SectorMasks_h

#include "Core/Rules/Pi.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

/// By the plain rule of triangles an edge point has this weight of each end.
constexpr double PlainEndWeight = 3. / 8.;

/// The weight gamma of the far end of an edge of a sector of triangles, each of which has this
/// angle. The end on the curve has 3/4 - gamma.
inline double GetFarEndWeight(double angle)
{
  return 0.5 - std::cos(angle) / 4.;
}

/// Keeps the angle of a sector away from 0, pi and 2 pi, where the rules degenerate. An angle that
/// is pi within `tie` counts as convex.
inline double ClampCornerAngle(double angle, double tie)
{
  return angle < Pi * (1. + tie) ? std::max(Pi / 8., std::min(angle, 7. * Pi / 8.))
                                 : std::max(9. * Pi / 8., std::min(angle, 15. * Pi / 8.));
}

/// The eigenvalue l3 of a sector of k triangles at a corner.
inline double GetThirdEigenvalueOfTriangles(int k, double angle)
{
  return 0.5 + (std::cos(Pi / k) - std::cos(angle / k)) / 4.;
}

/// The flatness s by which l3 becomes 1/4.
inline double GetFlatness(double third)
{
  return third > 0.25 ? 1. - 0.25 / third : 0.;
}

/// A new point with the coordinates c and s in the characteristic map moves towards a point in the
/// plane of the first and the last edge of its sector. Weights of the far ends of these edges in
/// that point. The corner itself has the rest.
struct FlatWeights
{
  double First;
  double Last;
};
inline FlatWeights GetFlatWeights(double angle, double c, double s)
{
  // Halved, because after the step the new points of the two sharp edges are at their midpoints.
  return { (c - s * std::cos(angle) / std::sin(angle)) / 2., s / std::sin(angle) / 2. };
}

/// The tangent across a curve in a sector of k > 1 faces. Inner edge j has the weight sin(j pi /
/// k), the face between edges j and j + 1 the weight Faces times the sum of both.
struct TransversalMask
{
  double Own;
  double End; ///< of the two edges on the curve
  double Faces;
};
inline TransversalMask GetTransversalMask(int k, bool quads, bool modified)
{
  const double t = Pi / static_cast<double>(k);
  const double cosine = std::cos(t);
  const double g =
    !modified ? PlainEndWeight : (quads ? 3. / 8. - cosine / 4. : GetFarEndWeight(t));
  const double a = g + cosine / 8.;
  const double value = quads
    ? (a + 0.25 + std::sqrt((a - 0.25) * (a - 0.25) + (1. + cosine) / 8.)) / 2.
    : g + cosine / 4.;
  const double sum = 1. / std::tan(t / 2.);
  const double faces = quads ? 1. / (16. * (value - 0.25)) : 0.;
  const double h = std::sin(t) * (quads ? 0.5 + 2. * faces : 1.);
  const double rest = (0.75 - g) * sum + faces * sum / 2.;
  const double d = value - 0.5;
  if (std::abs(d) < 1e-12)
  {
    return { -h, (value - 0.75) * -h - rest, faces };
  }
  const double own = (h / (8. * d) + rest) / (value - 0.75 - 1. / (8. * d));
  return { own, (own + h) / (8. * d), faces };
}

}

#endif
