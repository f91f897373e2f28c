// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightMasks.h"

#include "Core/Surfaces/Scheme/TurnedSectors.h"

#include <cmath>
#include <limits>

namespace subdivision
{

namespace
{

/// A left eigenvector by power iteration. All weights are positive, so that the largest eigenvalue
/// is simple; a quarter of the identity is added, because a step may nearly exchange edges and
/// faces. step(wave) takes the weights to the level before. Returns the eigenvalue.
template <typename Step>
double Iterate(FourEightWave& wave, const Step& step)
{
  constexpr double shift = 0.25;
  constexpr int most = 400;
  double known = 0.;
  for (int iteration = 0; iteration < most; ++iteration)
  {
    const FourEightWave next = step(wave);
    const double value = next.Edge / wave.Edge;
    const double scale = 1. / (next.Edge + shift * wave.Edge);
    const auto mix = [scale](double& to, double from) { to = (from + shift * to) * scale; };
    const bool isDone = std::abs(value - known) < 1e-16;
    mix(wave.Face, next.Face);
    mix(wave.Ahead, next.Ahead);
    mix(wave.KnightOfEdge, next.KnightOfEdge);
    mix(wave.KnightOfFace, next.KnightOfFace);
    mix(wave.Edge, next.Edge);
    known = value;
    if (isDone)
    {
      break;
    }
  }
  return known;
}

}

/// The condition that 1/2 is an eigenvalue of two steps is linear in h, and rational in the square
/// of the cosine of half the angle.
double GetFourEightFarWeight(double angle)
{
  const double x = (1. + std::cos(angle)) / 2.;
  return (2268. + x * (-793. + 2. * x)) / (2800. + x * (10109. + x * (-1468. + 4. * x)));
}

FourEightWave FourEightWave::PullBack(double c, double far) const
{
  const double knights = (c * this->KnightOfEdge + this->KnightOfFace) / 2.;
  FourEightWave next = *this;
  next.Edge = 2. * far * c * this->Edge + this->Face / 2. + c * this->Ahead / 4. + knights;
  next.Face = far * this->Edge + c * this->Face / 4. + this->Ahead / 2. +
    (this->KnightOfEdge + c * this->KnightOfFace) / 2.;
  next.Ahead = this->Face / 8. + knights;
  next.KnightOfEdge = this->KnightOfFace / 4.;
  next.KnightOfFace = this->Ahead / 8. + this->KnightOfEdge / 4.;
  return next;
}

FourEightWave::FourEightWave(double angle)
{
  const double c = std::cos(angle / 2.);
  this->Value = Iterate(*this, [c](const FourEightWave& wave) { return wave.PullBack(c, 0.25); });
}

FourEightWave::FourEightWave(double angle, double far)
{
  const double c = std::cos(angle / 2.);
  this->Value = std::sqrt(Iterate(*this,
    [c, far](const FourEightWave& wave) { return wave.PullBack(c, far).PullBack(c, 0.25); }));
}

double GetFourEightThirdEigenvalue(int k, double angle)
{
  if (IsWide(angle / k))
  {
    return std::numeric_limits<double>::infinity(); // the curves alone give the plane
  }
  const double root = FourEightWave(Pi / k, GetFourEightFarWeight(angle / k)).Value;
  return root * root;
}

/// Two steps take the weights on the curve to themselves: the odd one leaves the curve alone, the
/// even one has the rules of a cubic B-spline. Each adds weights of points inside.
FourEightCurveMask::FourEightCurveMask(int k, bool modified)
  : Inside(Pi / k, modified ? GetFourEightFarWeight(Pi / k) : 0.25)
{
  const double far = modified ? GetFourEightFarWeight(Pi / k) : 0.25;
  const FourEightWave& wave = this->Inside;
  const FourEightWave odd = wave.PullBack(std::cos(Pi / (2. * k)), far); // after the odd step
  const double value = wave.Value * wave.Value;
  const double first = std::sin(Pi / (2. * k)); // the sine of the first face
  double edges = 0.;
  double faces = 0.;
  for (int j = 0; j < k; ++j)
  {
    edges += std::sin(j * Pi / k);
    faces += std::sin((j + 0.5) * Pi / k);
  }
  this->Beyond = odd.KnightOfEdge * first / 4. / (value - 1. / 8.);
  const double atEnd = first * (odd.Edge / 4. + odd.Ahead / 8. + odd.KnightOfEdge / 4.) +
    first * (wave.Face / 8. + wave.KnightOfFace / 4.) + 3. / 4. * this->Beyond;
  const double atOwn = odd.Edge * faces / 4. + odd.Face * edges / 8. +
    (1. - 3. * far) * wave.Edge * edges + wave.Face * faces / 8. + this->Beyond / 4.;
  const double determinant = (value - 1.) * (value - 1. / 4.);
  this->End = ((value - 3. / 4.) * atEnd + atOwn / 8.) / determinant;
  this->Own = ((value - 1. / 2.) * atOwn + atEnd) / determinant;
}

}
