// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/VectorRanges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subdivision
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

}

void ExtendLongRange(int components, const double* by, double* range)
{
  for (int c = 0; c < components; ++c)
  {
    range[c] = std::min(range[c], by[c]);
  }
  for (int c = components; c <= 2 * components; ++c)
  {
    range[c] = std::max(range[c], by[c]);
  }
}

double Known(double bound)
{
  return bound < Infinity ? bound : Infinity; // also if it is not a number
}

double GetNorm(const double* vector, int components)
{
  double squares = 0.;
  for (int c = 0; c < components; ++c)
  {
    squares += vector[c] * vector[c];
  }
  return std::sqrt(squares);
}

VectorRanges::VectorRanges(vtkIdType items, int components)
  : Components(components)
  , Stride(2 * components + 1)
  , Values(Stride * items)
{
  ForEach(items, [this](vtkIdType i) { this->Clear(i); });
}

void VectorRanges::Clear(vtkIdType item)
{
  double* range = this->Values.data() + this->Stride * item;
  std::fill_n(range, this->Components, Infinity);
  std::fill_n(range + this->Components, this->Components, -Infinity);
  range[2 * this->Components] = 0.;
}

void VectorRanges::Add(vtkIdType item, const double* vector)
{
  double* range = this->Values.data() + this->Stride * item;
  for (int c = 0; c < this->Components; ++c)
  {
    double& least = range[c];
    double& largest = range[this->Components + c];
    const bool isKnown = std::isfinite(vector[c]);
    least = isKnown ? std::min(least, vector[c]) : -Infinity;
    largest = isKnown ? std::max(largest, vector[c]) : Infinity;
  }
  double& norm = range[2 * this->Components];
  norm = std::max(norm, Known(GetNorm(vector, this->Components)));
}

}
