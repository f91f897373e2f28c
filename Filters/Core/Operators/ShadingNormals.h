// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingNormals.h
 * Normals for points without tangent plane, which would be drawn black without a normal
 * (Mathematics 8).
 *
 * They follow from the *star* of a point: the directions in which its neighbours lie after so many
 * more steps that only the limit counts. A point at faces gets the mean of the normals of their
 * corners, weighted by angle, or, where these cancel, the sum of the areas beside it, or else the
 * normal of the largest one. A point with lines only gets a direction perpendicular to them. Two
 * lines count as the chord of their other ends, so that a curve has the normal of its tangent; else
 * the longest line counts. A point without faces and lines gets the z axis. Where several
 * directions are as good, the choice depends on coordinates and never on numbers of points or on
 * the order of calls.
 */
#ifndef SubdivisionObjects_ShadingNormals_h
#define SubdivisionObjects_ShadingNormals_h

#include <array>
#include <cstddef>
#include <vector>

namespace subdivision
{

/// A unit vector perpendicular to a vector of any length, in the plane of the vector and that axis
/// to which it is least parallel; the z axis for a vector without length or direction.
void FindPerpendicular(const double vector[3], double normal[3]);

/// The corners around one point, as vectors from there.
class ShadingStar
{
public:
  void Clear();
  /// Adds the corner of a face between its sides to `a` and `b`; `middle`: the face's. A `sign` of
  /// -1 reverses the normal, which else has the direction of a x b.
  void AddCorner(const double a[3], const double b[3], const double middle[3], double sign);
  /// Adds a line to `end`.
  void AddLine(const double end[3]);
  void FindNormal(double normal[3]);

private:
  using Vector = std::array<double, 3>;
  struct Corner
  {
    Vector A;
    Vector B;
    Vector Middle;
    double Sign;
  };
  std::vector<Corner> Corners;
  std::vector<Vector> Lines;
};

/// The most steps after which a star is looked at, counted from the control mesh.
constexpr int MostStepsOfStars = 40;

/**
 * The rows of a star so many steps later. `step` is its local matrix, of `size` items, the first of
 * which is the point itself; the result has, for each other item, the weights of all items: where
 * it will be, seen from the point. `corners`: the items at both sides of each corner. The star is
 * one of the level that is MostStepsOfStars after the control mesh, or, where the two sides of a
 * corner become parallel, or one of them much shorter, of that level on which they differ by 1e-4:
 * so rounding does not show. The level does not depend on the one from which steps begin, which is
 * `made` after the control mesh.
 */
std::vector<double> FindStarRows(const std::vector<double>& step, std::size_t size,
  const std::vector<std::array<int, 2>>& corners, int made);

}

#endif
