// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VectorRanges.h
 * Ranges of vectors: bounds on a mean of them.
 */
#ifndef SubdivisionObjects_VectorRanges_h
#define SubdivisionObjects_VectorRanges_h

#include "Core/Memory/Buffer.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// Extends a range by another one: the least components, the largest ones, and the norm.
template <int Components>
void ExtendRangeOf(const double* by, double* range)
{
  for (int c = 0; c < Components; ++c)
  {
    range[c] = std::min(range[c], by[c]);
  }
  for (int c = Components; c <= 2 * Components; ++c)
  {
    range[c] = std::max(range[c], by[c]);
  }
}
void ExtendLongRange(int components, const double* by, double* range);

/// The same; most time of bounds is spent here.
inline void ExtendRange(int components, const double* by, double* range)
{
  switch (components)
  {
    case 1:
      return ExtendRangeOf<1>(by, range);
    case 2:
      return ExtendRangeOf<2>(by, range);
    case 3:
      return ExtendRangeOf<3>(by, range);
    default:
      return ExtendLongRange(components, by, range);
  }
}

/// A range for each of many items: the least and the largest components of some vectors, and their
/// largest norm.
class VectorRanges
{
public:
  VectorRanges(vtkIdType items, int components);
  void Clear(vtkIdType item);
  void Add(vtkIdType item, const double* vector);
  /// Adds another range of as many components.
  void Extend(vtkIdType item, const double* range)
  {
    ExtendRange(this->Components, range, this->Values.data() + this->Stride * item);
  }
  const double* Get(vtkIdType item) const { return this->Values.data() + this->Stride * item; }

private:
  int Components;
  vtkIdType Stride;
  Buffer<double> Values;
};

/// A bound that is known, or infinity.
double Known(double bound);

double GetNorm(const double* vector, int components);

}

#endif
