// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightMasks.h
 * Weights of the 4-8 scheme (Mathematics 12): of rows, and of limits at a vertex around which all
 * is regular (FourEightStar.h).
 */
#ifndef SubdivisionObjects_FourEightMasks_h
#define SubdivisionObjects_FourEightMasks_h

#include <array>

namespace subdivision
{

/// The rows that many have: of a smooth vertex and its four neighbours.
inline constexpr std::array<double, 5> FourEightVertex{ 1. / 2., 1. / 8., 1. / 8., 1. / 8.,
  1. / 8. };
/// And of the centre of a quad.
inline constexpr std::array<double, 4> FourEightCentre{ 1. / 4., 1. / 4., 1. / 4., 1. / 4. };

/// The sums of the weights of a limit position: of the vertex, of its neighbours, of the opposite
/// corners of its faces, of the vertices straight ahead, and of the knight's moves.
struct FourEightTotals
{
  static constexpr double Own = 35. / 120.;
  static constexpr double Edges = 59. / 120.;
  static constexpr double Faces = 22. / 120.;
  static constexpr double Ahead = 3. / 120.;
  static constexpr double Knights = 1. / 120.;
};

/// The weight h of each of the three other corners in the centre that an even step makes beside a
/// vertex on a curve, which has 1 - 3 h, by the angle of one face of the sector. With it the
/// largest eigenvalue of two steps is 1/2 for waves of this angle, as on the curve itself.
double GetFourEightFarWeight(double angle);

/// The weights of a tangent where neighbouring edges are `angle` apart. Each is to be multiplied by
/// the cosine or the sine of a direction, of the edge or, for opposite corners, of the middle of
/// the face. A knight's move has two, of the edge and of the face between which it lies.
struct FourEightWave
{
  explicit FourEightWave(double angle);
  /// The same for a level after an even number of steps where the even step has the weight `far` of
  /// GetFourEightFarWeight. Value is the square root of the eigenvalue of two steps.
  FourEightWave(double angle, double far);
  /// The weights on the level before a step. c: the cosine of half the angle.
  FourEightWave PullBack(double c, double far) const;

  double Value = 0.; ///< the eigenvalue of one step
  double Edge = 1.;
  double Face = 1.;
  double Ahead = 1.;
  double KnightOfEdge = 1.;
  double KnightOfFace = 1.;
};

/// The eigenvalue l3 of two steps at a corner, in a sector of k > 1 faces with this angle.
double GetFourEightThirdEigenvalue(int k, double angle);

/// The weights of the tangent across a curve in a sector of k faces, k > 1, on a level after an
/// even number of steps. Inside the sector they follow the sine, which is zero on the curve.
struct FourEightCurveMask
{
  FourEightCurveMask(int k, bool modified);

  FourEightWave Inside;
  double Own = 0.;    ///< of the vertex
  double End = 0.;    ///< of both neighbours on the curve
  double Beyond = 0.; ///< of the next ones
};

}

#endif
