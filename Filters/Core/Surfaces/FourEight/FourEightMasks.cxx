// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightMasks.h"

#include "Core/Rules/Pi.h"

#include <cmath>

namespace subdivision
{

/// A left eigenvector by power iteration. All weights are positive, so that the largest eigenvalue
/// is simple; a quarter of the identity is added, because a step may nearly exchange edges and
/// faces.
FourEightWave::FourEightWave(double angle)
{
  constexpr double shift = 0.25;
  constexpr int most = 400;
  const double c = std::cos(angle / 2.);
  for (int iteration = 0; iteration < most; ++iteration)
  {
    const double knights = (c * this->KnightOfEdge + this->KnightOfFace) / 2.;
    FourEightWave next = *this;
    next.Edge = (c * this->Edge + this->Face) / 2. + c * this->Ahead / 4. + knights;
    next.Face = (this->Edge + c * this->Face) / 4. + this->Ahead / 2. +
      (this->KnightOfEdge + c * this->KnightOfFace) / 2.;
    next.Ahead = this->Face / 8. + knights;
    next.KnightOfEdge = this->KnightOfFace / 4.;
    next.KnightOfFace = this->Ahead / 8. + this->KnightOfEdge / 4.;
    const double value = next.Edge / this->Edge;
    const double scale = 1. / (next.Edge + shift * this->Edge);
    const auto mix = [scale](double& to, double from) { to = (from + shift * to) * scale; };
    const bool isDone = std::abs(value - this->Value) < 1e-16;
    mix(this->Face, next.Face);
    mix(this->Ahead, next.Ahead);
    mix(this->KnightOfEdge, next.KnightOfEdge);
    mix(this->KnightOfFace, next.KnightOfFace);
    mix(this->Edge, next.Edge);
    this->Value = value;
    if (isDone)
    {
      return;
    }
  }
}

/// Two steps take the weights on the curve to themselves: the odd one leaves the curve alone, the
/// even one has the rules of a cubic B-spline. Each adds weights of points inside.
FourEightCurveMask::FourEightCurveMask(int k)
  : Inside(Pi / k)
{
  const FourEightWave& wave = this->Inside;
  const double value = wave.Value * wave.Value;
  const double first = std::sin(Pi / (2. * k)); // the sine of the first face
  double edges = 0.;
  double faces = 0.;
  for (int j = 0; j < k; ++j)
  {
    edges += std::sin(j * Pi / k);
    faces += std::sin((j + 0.5) * Pi / k);
  }
  this->Beyond = wave.Value * wave.KnightOfEdge * first / 4. / (value - 1. / 8.);
  const double atEnd =
    wave.Value * first * (wave.Edge / 4. + wave.Ahead / 8. + wave.KnightOfEdge / 4.) +
    first * (wave.Face / 8. + wave.KnightOfFace / 4.) + 3. / 4. * this->Beyond;
  const double atOwn = wave.Value * (wave.Edge * faces / 4. + wave.Face * edges / 8.) +
    wave.Edge * edges / 4. + wave.Face * faces / 8. + this->Beyond / 4.;
  const double determinant = (value - 1.) * (value - 1. / 4.);
  this->End = ((value - 3. / 4.) * atEnd + atOwn / 8.) / determinant;
  this->Own = ((value - 1. / 2.) * atOwn + atEnd) / determinant;
}

}
