// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonEars.h
 * Polygons of five and more points as triangles, by cutting ears in the polygon's mean plane.
 */
#ifndef SubdivisionObjects_PolygonEars_h
#define SubdivisionObjects_PolygonEars_h

#include "Private/Reading/PointOrder.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPoints;

namespace subdivision
{

/**
 * An ear is a convex corner whose triangle contains no other corner of the polygon. The ear with
 * the shortest diagonal is cut first, among equal ones (to 1e-9, of points
 * in single precision to 1e-5) that with the smallest point.
 * Polygons without ears (collinear, crossing themselves) are cut all the same: n points always give
 * n - 2 triangles. One object serves one thread and keeps its memory from polygon to polygon.
 */
class PolygonEars
{
public:
  PolygonEars(vtkPoints* points, const PointOrder& order);

  /// `loop`: at least three valid ids of finite points. The result lives until the next call.
  const std::vector<std::array<vtkIdType, 3>>& Cut(const vtkIdType* loop, vtkIdType size);

private:
  struct Corner
  {
    double X[2] = {};
    vtkIdType Id = 0;
    vtkIdType Next = 0;
    vtkIdType Previous = 0;
    double Diagonal2 = 0; ///< squared length of the edge that cutting it would make
    bool IsEar = false;
  };

  /// `cross`: twice the area of a triangle with sides of these squared lengths; beyond what may be
  /// rounding its sign can be trusted.
  bool IsBeyond(double cross, double length2a, double length2b, double sign) const;
  void Project(const vtkIdType* loop, vtkIdType size);
  void Examine(Corner& corner) const;
  bool IsFree(const Corner& corner) const;
  vtkIdType FindBestEar(vtkIdType start) const;
  vtkIdType FindLeastHarm(vtkIdType start) const;

  vtkPoints* Points;
  PointOrder Order;
  double Tie;       ///< lengths that differ by less, relatively, are equal
  double LeastSine; ///< what is below counts as zero
  std::vector<Corner> Corners;
  std::vector<std::array<double, 3>> Loop; ///< of the loop
  std::vector<std::array<vtkIdType, 3>> Triangles;
};

}

#endif
