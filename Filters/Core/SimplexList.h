// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplexList.h
 * Ordered simplices of mixed dimension, in the order in which the output has them (SPEC 2: the
 * order of a simplex's vertices is inherited by its children).
 */
#ifndef SubdivisionObjects_SimplexList_h
#define SubdivisionObjects_SimplexList_h

#include "vtkType.h"

#include <vector>

namespace subdivision
{

struct SimplexList
{
  /// Number of points the simplices may name; unused points count.
  vtkIdType NumberOfPoints = 0;
  /// Dimension 0..3 of each simplex.
  std::vector<unsigned char> Dimensions;
  /// Dimension + 1 point ids per simplex, one simplex after the other.
  std::vector<vtkIdType> Connectivity;

  vtkIdType GetNumberOfSimplices() const { return static_cast<vtkIdType>(this->Dimensions.size()); }
};

}

#endif
