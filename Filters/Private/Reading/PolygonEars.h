// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonEars.h
 * Polygons of five and more points as triangles, by cutting ears in the polygon's mean plane.
 */
#ifndef SubdivisionObjects_PolygonEars_h
#define SubdivisionObjects_PolygonEars_h

#include "Private/Reading/EarSearch.h"
#include "Private/Reading/PointOrder.h"

#include "vtkType.h"

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
 * Up to FewCorners corners are looked at in turn, which takes n^2 steps and is the fastest way for
 * them. More are searched by EarSearch.h and give the same triangles in about n log n steps. Slow
 * is only a polygon whose ears are nearly flat triangles, up to the sine that counts as zero: what
 * they might contain is not bounded.
 */
class PolygonEars
{
public:
  PolygonEars(vtkPoints* points, const PointOrder& order);

  /// `loop`: at least three valid ids of finite points. The result lives until the next call.
  const std::vector<std::array<vtkIdType, 3>>& Cut(const vtkIdType* loop, vtkIdType size);

  /// Tests change it.
  static inline vtkIdType FewCorners = 64;

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
  void StartSearch();
  void Examine(vtkIdType tip);
  bool Bends(const Corner& corner, double sign) const;
  bool IsFree(vtkIdType tip) const;
  /// No ear is left: the smallest point that does not bend inwards, or else the smallest one.
  vtkIdType FindLeastHarm(vtkIdType start) const;
  vtkIdType FindBestEar(vtkIdType start) const;
  void Remove(vtkIdType tip);

  bool Searches() const { return static_cast<vtkIdType>(this->Corners.size()) > FewCorners; }
  bool Precedes(vtkIdType a, vtkIdType b) const
  {
    return this->Order(this->Corners[a].Id, this->Corners[b].Id);
  }
  vtkIdType FindSmallest(const FirstOfLeast& values, double most, vtkIdType start) const;

  vtkPoints* Points;
  PointOrder Order;
  double Tie;       ///< lengths that differ by less, relatively, are equal
  double LeastSine; ///< sines below this count as zero
  std::vector<Corner> Corners;
  std::vector<std::array<double, 3>> Loop; ///< coordinates of the points of the loop
  std::vector<std::array<vtkIdType, 3>> Triangles;

  // Of more than FewCorners corners. The rank of a corner is its place in the order of points, then
  // in the loop.
  std::vector<vtkIdType> ByRank;
  std::vector<vtkIdType> Ranks;
  FirstOfLeast Diagonals; ///< Diagonal2 of ears, by rank
  FirstOfLeast Harms;     ///< 1 for what bends inwards, 0 for others, by rank
  PlanePoints Left;
};

}

#endif
