// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/TetFrame.h"

#include "Core/Operators/CornerRows.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{

using namespace vectors;

TetFrame::TetFrame(const double* const corners[4])
  : First(corners[0])
{
  for (int i = 0; i < 3; ++i)
  {
    this->Edges[i] = Subtract(corners[i + 1], corners[0]);
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Normals[i] = Cross(this->Edges[(i + 1) % 3], this->Edges[(i + 2) % 3]);
  }
  this->Volume = Dot(this->Edges[0], this->Normals[0]);
}

bool TetFrame::IsFlat(double least) const
{
  double product = 1.;
  for (const Vector& edge : this->Edges)
  {
    product *= std::sqrt(Dot(edge, edge));
  }
  return !(std::abs(this->Volume) > least * product);
}

std::array<double, 4> TetFrame::GetWeights(const double x[3]) const
{
  Vector rest = Subtract(x, this->First);
  Vector found = { 0., 0., 0. };
  // The second round takes away the rest that rounding leaves in thin cells.
  for (int round = 0; round < 2; ++round)
  {
    Vector left = rest;
    for (int i = 0; i < 3; ++i)
    {
      const double step = Dot(rest, this->Normals[i]) / this->Volume;
      found[i] += step;
      for (int c = 0; c < 3; ++c)
      {
        left[c] -= step * this->Edges[i][c];
      }
    }
    rest = left;
  }
  return CompleteWeights(found.data());
}

bool FindWeightsInTet(const double* const corners[4], const double x[3], double weights[4])
{
  const TetFrame tet(corners);
  if (tet.IsFlat())
  {
    return false;
  }
  const std::array<double, 4> found = tet.GetWeights(x);
  std::copy(found.begin(), found.end(), weights);
  return true;
}

bool FindGradientsInTet(const double* const corners[4], double gradients[4][3])
{
  const TetFrame tet(corners);
  for (int c = 0; c < 3; ++c)
  {
    gradients[0][c] = 0.;
    for (int i = 0; i < 3; ++i)
    {
      gradients[i + 1][c] = tet.Normals[i][c] / tet.Volume;
      gradients[0][c] -= gradients[i + 1][c];
    }
  }
  return !tet.IsFlat();
}

int GetOrientationOfTet(const double* const corners[4], double least)
{
  // Most tetrahedra are far from flat, which is found without square roots.
  const Vector edges[3] = { Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]),
    Subtract(corners[3], corners[0]) };
  const double volume = Dot(edges[0], Cross(edges[1], edges[2]));
  const double product =
    Dot(edges[0], edges[0]) * Dot(edges[1], edges[1]) * Dot(edges[2], edges[2]);
  constexpr double margin = 1.0001; // far above rounding
  const bool isInRange = product > 1e-200 && product < 1e200;
  if (isInRange && volume * volume > margin * least * least * product)
  {
    return volume > 0. ? 1 : -1;
  }
  const TetFrame tet(corners);
  return tet.IsFlat(least) ? 0 : tet.Volume > 0. ? 1 : -1;
}

}
