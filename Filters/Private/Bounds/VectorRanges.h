// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VectorRanges.h
 * Ranges of vectors: what is known of a mean of them.
 */
#ifndef SubdivisionObjects_VectorRanges_h
#define SubdivisionObjects_VectorRanges_h

#include "Core/Memory/Buffer.h"

#include <vector>

namespace subdivision
{

/// The least and the largest components of some vectors, and their largest norm.
class VectorRange
{
public:
  explicit VectorRange(int components);
  void Clear();
  /// Adds a range as VectorRanges has it.
  void Add(const double* range);
  void AddZero();
  double GetLeast(int component) const { return this->Values[component]; }
  double GetLargest(int component) const { return this->Values[this->Components + component]; }
  double GetNorm() const { return this->Values[2 * this->Components]; }

private:
  int Components;
  std::vector<double> Values;
};

/// A range for each of many items.
class VectorRanges
{
public:
  VectorRanges(vtkIdType items, int components);
  void Add(vtkIdType item, const double* vector);
  /// Adds another range of as many components.
  void Extend(vtkIdType item, const double* range);
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
