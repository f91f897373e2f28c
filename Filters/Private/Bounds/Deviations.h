// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Deviations.h
 * How far steps move points away from the middles of old ones, and what bound on the distance from
 * the limit follows (Mathematics 14).
 */
#ifndef SubdivisionObjects_Deviations_h
#define SubdivisionObjects_Deviations_h

#include "Core/Memory/Buffer.h"
#include "Private/Bounds/NestedPieces.h"

#include <functional>
#include <vector>

namespace subdivision
{

/// The least and the largest components of some vectors, and their largest norm.
class VectorRange
{
public:
  explicit VectorRange(int components);
  void Clear();
  /// Adds a range as Deviations has it.
  void Add(const double* range);
  void AddZero();
  double GetLeast(int component) const { return this->Values[component]; }
  double GetLargest(int component) const { return this->Values[this->Components + component]; }
  double GetNorm() const { return this->Values[2 * this->Components]; }

private:
  int Components;
  std::vector<double> Values;
};

/// For each point after all steps the range of some vectors, those that belong to it and to the
/// points around it.
class Deviations
{
public:
  Deviations(const NestedPieces& pieces, int components);
  /// Adds a vector to a point.
  void Add(vtkIdType point, const double* vector);
  /// Extends the ranges of points by those around them, in so many layers of pieces.
  void Spread(int layers);

  const double* Get(vtkIdType point) const { return this->Values.data() + this->Stride * point; }

private:
  void SpreadOnce();

  const NestedPieces& Pieces;
  int Components;
  vtkIdType Stride;
  Buffer<double> Values;
};

/// Values of one array at the points of an output, and after one further step.
struct BoundedValues
{
  int Components;
  const double* Shown;        ///< of the output
  const Buffer<double>& Next; ///< control values after one step
  /// Applies step 2 or 3.
  std::function<Buffer<double>(int step, const Buffer<double>& values)> Step;
  double Rounding; ///< what all bounds are increased by
};

/// Sets the bound of each cell; infinity where values are not finite.
void FindBounds(const NestedPieces& pieces, const BoundedValues& values, double* bounds);

}

#endif
