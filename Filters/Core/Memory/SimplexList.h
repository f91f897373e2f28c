// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplexList.h
 * Lists of simplices of mixed dimension. The simplices have the order of the output cells. The
 * order of the vertices of a simplex counts too, because its children inherit it (Mathematics 2).
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

/// A view of simplices in arrays that the caller owns.
struct SimplexView
{
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfSimplices = 0;
  const unsigned char* Dimensions = nullptr; ///< 0..3 of each simplex
  const vtkIdType* Connectivity = nullptr;   ///< dimension + 1 points each, one after the other
  const unsigned char* Levels = nullptr;     ///< of each simplex; null: all are 0

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
