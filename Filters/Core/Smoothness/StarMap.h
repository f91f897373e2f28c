// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StarMap.h
 * A characteristic map as a mesh: its points are eigenvectors.
 */
#ifndef SubdivisionObjects_StarMap_h
#define SubdivisionObjects_StarMap_h

#include "Core/Smoothness/SmoothnessFacts.h"

#include <array>
#include <vector>

namespace subdivision
{

struct StarMap
{
  using Point = std::array<double, 3>;

  /// 2 of a surface, 3 of a solid; 0: there is no map.
  int Dimension = 0;
  SmoothnessFacts Facts;
  std::vector<Point> Points; ///< third coordinate 0 on surfaces
  std::vector<double> Rings; ///< of each point: how many rings it is away from the middle
  std::vector<int> Ends;     ///< of the corners of each cell
  std::vector<int> Corners;  ///< polygons, or tetrahedra of 4 each
  /// Of each cell: its size, as a multiple of its size in the mesh that is mapped. Negative where
  /// the map turns it over.
  std::vector<double> Jacobians;

  bool IsEmpty() const { return this->Dimension == 0; }
};

/// Makes a map of points and cells. A point is not known where it is not a number.
class StarMapMaker
{
public:
  using Point = StarMap::Point;

  StarMapMaker(int dimension, std::vector<Point> points, std::vector<double> rings)
    : Dimension(dimension)
    , Points(std::move(points))
    , Rings(std::move(rings))
  {
  }

  bool IsKnown(int point) const;
  /// Adds a cell, unless one of its corners is not known. `size`: in the mesh that is mapped, with
  /// the sign of its orientation.
  void AddCell(const int* corners, int count, double size);

  /**
   * The map with the middle in the origin. Eigenvectors have no scale, and where eigenvalues are
   * equal no direction. So one of all linear images is chosen: its points have equal moments in all
   * directions, point `first` lies on the x axis, as far away as Rings says, and point `second` in
   * the upper half of the x-y plane. Most of its cells have a positive Jacobian.
   */
  StarMap Make(int middle, int first, int second) const;

private:
  void Straighten(int middle, int first, int second, std::vector<Point>& points) const;
  void Apply(const std::array<Point, 3>& rows, std::vector<Point>& points) const;
  double FindSize(const std::vector<Point>& points, std::size_t cell) const;

  const int Dimension;
  const std::vector<Point> Points;
  const std::vector<double> Rings;
  std::vector<int> Ends;
  std::vector<int> Corners;
  std::vector<double> Sizes;
};

}

#endif
