// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearPoints.h
 * Which points are at one place, or nearly.
 */
#ifndef SubdivisionObjects_NearPoints_h
#define SubdivisionObjects_NearPoints_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/Box.h"
#include "Private/Reading/PointOrder.h"

#include <numeric>
#include <vector>

namespace subdivision
{

/// The length of the diagonal, which is the size of the content of the box; 0 where it is empty.
double GetDiagonal(const Box& box);

/// Sets of numbers that are joined; each is known by its least number.
class Sets
{
public:
  explicit Sets(vtkIdType size)
    : Parents(size)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), vtkIdType(0));
  }
  vtkIdType Find(vtkIdType item)
  {
    while (this->Parents[item] != item)
    {
      this->Parents[item] = this->Parents[this->Parents[item]];
      item = this->Parents[item];
    }
    return item;
  }
  void Join(vtkIdType a, vtkIdType b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

private:
  Buffer<vtkIdType> Parents;
};

/**
 * For each of `points` the first one of its group, by `order`. Two points are in one group where
 * they are at most `tolerance` apart (0: equal; -0 is 0), or where a chain of such steps leads from
 * one to the other. So groups depend neither on the order of points nor on threads. A point that is
 * not finite is alone.
 *
 * Sorts the points by the cells of a grid, within which all are near each other, and compares
 * neighbouring cells: n log n steps, unless very many are nearly as far apart as `tolerance`.
 * Without a tolerance one look at each point is enough.
 */
Buffer<vtkIdType> FindFirstOfNear(
  const double* x, const std::vector<vtkIdType>& points, double tolerance, const PointOrder& order);

}

#endif
