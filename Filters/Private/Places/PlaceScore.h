// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceScore.h
 * A score that compares places that may be the nearest one to a point (LimitPatches.h).
 */
#ifndef SubdivisionObjects_PlaceScore_h
#define SubdivisionObjects_PlaceScore_h

#include "Core/Memory/Vectors.h"
#include "Core/Solids/Location/Box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subdivision
{

/// Searches make it smaller instead of the distance from a point: half its square near the patches,
/// and else the part of the distance that depends on the place, so that nothing cancels.
class PlaceScore
{
public:
  using Vector = vectors::Vector;

  /// Of places in patches of size 1 whose middle is the origin.
  explicit PlaceScore(const Vector& point)
    : Point(point)
    , Far(std::hypot(point[0], point[1], point[2]))
    , IsNear(this->Far <= Near)
  {
  }
  /// Of two control points: the score is this, summed with the weights of their product.
  double Multiply(const Vector& a, const Vector& b) const
  {
    return this->IsNear
      ? 0.5 * vectors::Dot(vectors::Subtract(a, this->Point), vectors::Subtract(b, this->Point))
      : 0.5 * (vectors::Dot(a, b) - vectors::Dot(a, this->Point) - vectors::Dot(b, this->Point)) /
        this->Far;
  }
  double Of(const Vector& place) const { return this->Multiply(place, place); }
  /// No place in a box has less.
  double Bound(const Box& box) const
  {
    Vector nearest{};
    for (int c = 0; c < 3; ++c)
    {
      nearest[c] = std::max(box.Low[c], std::min(box.High[c], this->Point[c]));
    }
    return box.Low[0] <= box.High[0] ? this->Of(nearest) : std::numeric_limits<double>::infinity();
  }
  /// Of a place that may be nearer, or farther if `margin` is negative.
  double Lower(double score, double margin) const
  {
    if (!this->IsNear)
    {
      return score - 2. * margin;
    }
    const double distance = std::max(0., std::sqrt(2. * std::max(0., score)) - margin);
    return 0.5 * distance * distance;
  }
  /// By how much equal scores may differ. `part`: of the values, as rounding.
  double GetTolerance(double score, double part) const
  {
    return part * (this->IsNear ? 100. * score + 1e-5 : 1.);
  }

private:
  static constexpr double Near = 4.; ///< sizes

  const Vector Point;
  const double Far;
  const bool IsNear;
};

}

#endif
