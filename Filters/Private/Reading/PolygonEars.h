// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonEars.h
 * Polygons of five and more points as triangles, by cutting ears in the polygon's mean plane.
 */
#ifndef SubdivisionObjects_PolygonEars_h
#define SubdivisionObjects_PolygonEars_h

#include "Private/Reading/PointOrder.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <vector>

class vtkPoints;

namespace subdivision
{

/**
 * An ear is a convex corner whose triangle contains no other corner of the polygon. The ear with
 * the shortest diagonal is cut off first; among equal ones (to a relative 1e-9, for points in
 * single precision 1e-5) the one with the smallest point. A polygon without ears, because it is
 * collinear or crosses itself, is cut all the same: n points always give n - 2 triangles. Each
 * thread needs an object of its own, which reuses its memory for all polygons.
 *
 * All corners are looked at for each ear, which takes n^2 steps. Polygons of more than MostCorners
 * corners are cut by vtkPolygon, which finds other ears faster: 0.4 s for 10^4 corners. Where that
 * fails, as it may for polygons that touch or cross themselves, they are cut like all others: 2 s.
 */
class PolygonEars
{
public:
  PolygonEars(vtkPoints* points, const PointOrder& order);

  /// `loop`: at least three valid ids of finite points. The result lives until the next call.
  const std::vector<std::array<vtkIdType, 3>>& Cut(const vtkIdType* loop, vtkIdType size);

  /// Calls visit(a, b, c) for the triangles of a face of more than four points. Two cells at it,
  /// which pass it in opposite directions, cut it alike: from its smallest point on, to the smaller
  /// side. Moves the points of the loop.
  template <typename Visit>
  void CutFace(vtkIdType* loop, vtkIdType size, const Visit& visit)
  {
    std::rotate(loop, std::min_element(loop, loop + size, this->Order), loop + size);
    const bool turns = this->Order(loop[size - 1], loop[1]);
    if (turns)
    {
      std::reverse(loop + 1, loop + size);
    }
    for (const auto& t : this->Cut(loop, size))
    {
      visit(t[0], t[turns ? 2 : 1], t[turns ? 1 : 2]);
    }
  }

  static constexpr vtkIdType MostCorners = 2000;

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

  /// `cross`: twice the area of a triangle with sides of these squared lengths; beyond rounding its
  /// sign can be trusted.
  bool IsBeyond(double cross, double length2a, double length2b, double sign) const;
  void Project(const vtkIdType* loop, vtkIdType size);
  bool CutByVTK();
  void Examine(vtkIdType tip);
  bool Bends(const Corner& corner, double sign) const;
  bool IsFree(vtkIdType tip) const;
  /// No ear is left: the smallest point that does not bend inwards, or else the smallest one.
  vtkIdType FindLeastHarm(vtkIdType start) const;
  vtkIdType FindBestEar(vtkIdType start) const;

  bool Precedes(vtkIdType a, vtkIdType b) const
  {
    return this->Order(this->Corners[a].Id, this->Corners[b].Id);
  }

  vtkPoints* Points;
  PointOrder Order;
  double Tie;       ///< lengths that differ by less, relatively, are equal
  double LeastSine; ///< sines below this count as zero
  std::vector<Corner> Corners;
  std::vector<std::array<double, 3>> Loop; ///< coordinates of the points of the loop
  std::vector<std::array<vtkIdType, 3>> Triangles;
};

}

#endif
