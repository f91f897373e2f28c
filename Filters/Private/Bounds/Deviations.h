// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Deviations.h
 * How far steps move points away from the middles of old ones, and the bound on the distance from
 * the limit that follows (Mathematics 14).
 */
#ifndef SubdivisionObjects_Deviations_h
#define SubdivisionObjects_Deviations_h

#include "Core/Memory/Buffer.h"
#include "Private/Bounds/NestedPieces.h"
#include "Private/Bounds/Sectors.h"

#include <functional>
#include <limits>
#include <vector>

namespace subdivision
{

/// Values of one array at the points of cells, and after further steps.
struct BoundedValues
{
  int Components;
  const double* Shown;          ///< at the corners of cells
  const Buffer<double>& Next;   ///< control values after one step
  const Buffer<double>& Second; ///< after two
  const Buffer<double>& Third;  ///< after three
  /// Applies step 3.
  std::function<Buffer<double>(const Buffer<double>& values)> LastStep;
  double Rounding; ///< is added to all bounds
};

/// Bounds on the largest distance of a cell.
struct CellBound
{
  double Least = 0.;            ///< it is not smaller; 0: nothing is known
  double Largest = 0.;          ///< nor larger; infinity where values are not finite
  std::vector<double> OfPieces; ///< Largest of each of its pieces, where asked for
};

/// A bound may be so many times the least distance. Readers are promised a little more (Mathematics
/// 14).
constexpr double NearBound = 2.5;

/// Whether a bound is near enough, or no more than rounding, or not finite.
inline bool IsNear(double bound, double least, double rounding)
{
  return bound <= NearBound * least || bound <= 16. * rounding ||
    !(bound < std::numeric_limits<double>::infinity());
}

/// Finds the bounds of some cells, with bounds of pieces where the cell's is not near.
std::vector<CellBound> FindBounds(const NestedPieces& pieces, const Sectors& sectors,
  const BoundedValues& values, const std::vector<vtkIdType>& cells);

/// Adds the value that a cell shows at one of its points, times a factor, to `value`.
void AddShown(const NestedPieces& pieces, const BoundedValues& values, vtkIdType cell, int point,
  double factor, double* value);

}

#endif
