// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SplineColumns.h
 * The rows of places in a triangle or quad inside of a regular surface, as nearly all are: each
 * control point of the spline is a vertex, and no two are the same. Needs no memory but its own.
 */
#ifndef SubdivisionObjects_SplineColumns_h
#define SubdivisionObjects_SplineColumns_h

#include "Core/Operators/BoxSpline.h"

#include <algorithm>
#include <array>
#include <utility>

namespace subdivision
{

template <typename Id>
class SplineColumns
{
public:
  static constexpr int Most = BicubicPoints;

  /// Takes the control points: BoxSplinePoints or BicubicPoints. False: two are the same.
  bool Set(const std::array<Id, Most>& points, int size)
  {
    std::array<std::pair<Id, int>, Most> sorted;
    for (int j = 0; j < size; ++j)
    {
      sorted[j] = { points[j], j };
    }
    std::sort(sorted.begin(), sorted.begin() + size);
    for (int c = 0; c < size; ++c)
    {
      this->Vertices[c] = sorted[c].first;
      this->OfPoints[sorted[c].second] = static_cast<unsigned char>(c);
    }
    const Id* first = this->Vertices.data();
    this->Size = std::adjacent_find(first, first + size) == first + size ? size : 0;
    return this->Size > 0;
  }

  /// The number of columns; 0: none were set.
  int GetSize() const { return this->Size; }
  /// The vertices, ascending.
  const Id* begin() const { return this->Vertices.data(); }
  const Id* end() const { return this->begin() + this->Size; }

  /// Sets a weight for each column, in the wanted parts of PlaceParts.
  void Weight(double u, double v, const PatchDirections& directions, const PlaceSums& weights) const
  {
    const PlaceDerivatives derivatives =
      weights[PlaceParts::Second] ? PlaceDerivatives::Second : PlaceDerivatives::First;
    PatchParts ofPoints;
    this->Size == BoxSplinePoints ? WeightBoxSpline(u, v, directions, derivatives, ofPoints)
                                  : WeightBicubic(u, v, directions, derivatives, ofPoints);
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      if (!weights[p])
      {
        continue;
      }
      if (p == PlaceParts::First + 2) // there is no third parameter
      {
        std::fill_n(weights[p], this->Size, 0.);
        continue;
      }
      for (int j = 0; j < this->Size; ++j)
      {
        weights[p][this->OfPoints[j]] = ofPoints[p][j];
      }
    }
  }

private:
  int Size = 0;
  std::array<Id, Most> Vertices;
  std::array<unsigned char, Most> OfPoints; ///< the column of each control point
};

}

#endif
