// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceSamples.h
 * Which points of an image lie in a quadratic piece, and where there.
 */
#ifndef SubdivisionObjects_PieceSamples_h
#define SubdivisionObjects_PieceSamples_h

#include <array>
#include <vector>

namespace subdivision
{

/// The points of an image: Origin + index * Spacing, for all indices from Extent[2 * axis] to
/// Extent[2 * axis + 1].
struct SampleGrid
{
  std::array<double, 3> Origin;
  std::array<double, 3> Spacing;
  std::array<int, 6> Extent;

  double GetPlace(int axis, int index) const
  {
    return this->Origin[axis] + index * this->Spacing[axis];
  }
  /// The first index at a place or after it, not before the extent; the last one likewise.
  int GetFirst(int axis, double place) const;
  int GetLast(int axis, double place) const;
};

using Place = std::array<double, 3>;

/// Shares of the ten nodes of a quadratic tetrahedron where the corners but the first have these.
std::array<double, 10> GetShares(const Place& weights);

/**
 * Finds the samples in a quadratic tetrahedron. Along a row of the image the straight tetrahedron,
 * its faces moved out as far as control points are, bounds them; there each sample is found by
 * Newton's method, from where its neighbour is.
 */
class TetrahedronSamples
{
public:
  /// `nodes`: corners, then the middles of 01, 02, 12, 03, 13, 23.
  explicit TetrahedronSamples(const std::array<Place, 10>& nodes);

  /// The smallest box around the control points.
  const Place& GetLow() const { return this->Low; }
  const Place& GetHigh() const { return this->High; }

  /// Calls act(i, weights) for the samples of row (j, k) in the piece that `wants(i)` asks for.
  template <typename Wants, typename Act>
  void ForRow(const SampleGrid& grid, int j, int k, const Wants& wants, const Act& act) const
  {
    const double y = grid.GetPlace(1, j);
    const double z = grid.GetPlace(2, k);
    double low = this->Low[0];
    double high = this->High[0];
    if (!this->Clip(y, z, low, high))
    {
      return;
    }
    Place weights{};
    bool isNear = false;
    const int last = grid.GetLast(0, high);
    for (int i = grid.GetFirst(0, low); i <= last; ++i)
    {
      isNear = wants(i) && this->Find({ grid.GetPlace(0, i), y, z }, isNear, weights);
      if (isNear)
      {
        act(i, weights);
      }
    }
  }

  /// Whether a box may reach into the piece, given by its middle and half of its lengths.
  bool MayReach(const Place& middle, const Place& half) const;
  bool Contains(const Place& place) const
  {
    Place weights{};
    return this->MayReach(place, {}) && this->Find(place, false, weights);
  }

  /// Points this near to a face, in weights, are in the cells of both sides, so that rounding
  /// leaves none out.
  static constexpr double Near = 1e-9;
  static bool IsInside(const Place& w)
  {
    return w[0] >= -Near && w[1] >= -Near && w[2] >= -Near && w[0] + w[1] + w[2] <= 1. + Near;
  }

private:
  /// Where weights are, from the first corner on.
  Place Evaluate(const Place& weights) const;
  bool Clip(double y, double z, double& low, double& high) const;
  /// Finds the weights of a place, from `weights` on if `isNear`. Returns whether it has.
  bool Find(const Place& place, bool isNear, Place& weights) const;
  /// `place`: from the first corner on, as that of GetStraightWeights.
  bool Iterate(const Place& place, Place& weights) const;
  Place GetStraightWeights(const Place& place) const;

  /// The first corner. All but the box is told from it on, so that objects far from the origin do
  /// not lose digits.
  Place Origin;
  Place Low, High;
  /// Coefficients of 1, u, v, w, uu, vv, ww, uv, uw, vw.
  std::array<Place, 10> Powers;
  bool IsFlat = false; ///< the straight tetrahedron has no volume
  /// The weights of the straight tetrahedron, as planes, and their least values at control points.
  std::array<std::array<double, 4>, 4> Planes{};
  std::array<double, 4> Least{};
};

/// The weights of the point of a straight triangle, line or point that is nearest to a place, and
/// its distance squared.
struct NearestPoint
{
  std::array<double, 3> Weights;
  double Square;
};
NearestPoint FindNearest(const Place* corners, int size, const Place& place);

}

#endif
