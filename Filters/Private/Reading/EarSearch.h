// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EarSearch.h
 * What cutting a polygon of many corners asks again and again, in logarithmic time for usual
 * polygons: which corner is the first of the least, and whether a corner is in a triangle.
 */
#ifndef SubdivisionObjects_EarSearch_h
#define SubdivisionObjects_EarSearch_h

#include "vtkType.h"

#include <array>
#include <vector>

namespace subdivision
{

/// A value for each place, infinite until it is set: a binary tree of minima.
class FirstOfLeast
{
public:
  void Reset(vtkIdType size);
  void Set(vtkIdType place, double value);
  /// Infinite if all values are.
  double GetLeast() const { return this->Least[1]; }
  /// The first place, from `from` on, whose value is at most `value`, which is finite; or -1.
  vtkIdType FindFirst(double value, vtkIdType from) const;

private:
  vtkIdType Leaves = 1;
  std::vector<double> Least; ///< node i has the children 2 i and 2 i + 1
};

/// A triangle in the plane whose corners run anticlockwise. Sines below `LeastSine` count as zero.
class EarTriangle
{
public:
  EarTriangle(const double* a, const double* b, const double* c, double leastSine);

  /// Finds what IsBeyond needs.
  void Bound();

  /// Whether the point is neither outside nor at the same place as a corner: where two parts of the
  /// polygon touch (a bridge to a hole) points coincide.
  bool Contains(const double* point) const;
  /// Whether no point of the box can be contained. False where it is not certain.
  bool IsBeyond(const double* low, const double* high) const;

private:
  struct Side
  {
    const double* From;
    const double* To;
    double Length2;
  };

  Side Sides[3];
  double LeastSine;
  bool HasBox = false; ///< whether what is contained is bounded: not in nearly flat triangles
  double Low[2] = { 0., 0. };
  double High[2] = { 0., 0. };
};

/// Points in the plane, which are removed one after the other: a binary tree of boxes.
class PlanePoints
{
public:
  void Reset(std::vector<std::array<double, 2>> points);
  void Remove(vtkIdType point);
  /// Whether the triangle contains any point but these three, which are its corners.
  bool HasAnyIn(const EarTriangle& triangle, const std::array<vtkIdType, 3>& corners) const;

private:
  struct Node
  {
    double Low[2];
    double High[2];
    vtkIdType Begin; ///< in Order
    vtkIdType End;
    vtkIdType Left; ///< points in it that are not removed
    vtkIdType Parent;
    vtkIdType Second; ///< the second child; the first one is the next node. 0 in leaves
  };

  vtkIdType Build(vtkIdType begin, vtkIdType end, vtkIdType parent);

  std::vector<std::array<double, 2>> Points;
  std::vector<vtkIdType> Order; ///< -1 where a point was removed
  std::vector<vtkIdType> Leaf;  ///< the node of each point
  std::vector<Node> Nodes;
};

/// Twice the area of a triangle, positive if its corners run anticlockwise.
inline double Cross2(const double* a, const double* b, const double* p)
{
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

inline double Distance2(const double* a, const double* b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

}

#endif
