// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplexList.h
 * Ordered simplices of mixed dimension, in the order in which the output has them (Mathematics 2:
 * the order of a simplex's vertices is inherited by its children).
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

/// Simplices in arrays that somebody else keeps.
struct SimplexView
{
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfSimplices = 0;
  const unsigned char* Dimensions = nullptr; ///< 0..3 of each simplex
  const vtkIdType* Connectivity = nullptr;   ///< dimension + 1 points each, one after the other
  const unsigned char* Levels = nullptr;     ///< of each simplex; none: all 0

  SimplexView() = default;
  explicit SimplexView(const SimplexList& list)
    : NumberOfPoints(list.NumberOfPoints)
    , NumberOfSimplices(list.GetNumberOfSimplices())
    , Dimensions(list.Dimensions.data())
    , Connectivity(list.Connectivity.data())
  {
  }
  int GetLevel(vtkIdType simplex) const { return this->Levels ? this->Levels[simplex] : 0; }
};

}

#endif
