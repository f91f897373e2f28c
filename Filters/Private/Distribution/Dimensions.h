// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Dimensions.h
 * Takes the cells of some dimensions out of a mesh.
 */
#ifndef SubdivisionObjects_Dimensions_h
#define SubdivisionObjects_Dimensions_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkDataObject;

namespace subdivision
{

/// The sum of 2 to the power of each dimension.
constexpr int AllDimensions = 15;

/**
 * Makes meshes of the cells of some dimensions, whose powers of 2 `dimensions` is the sum of, and
 * the points that these cells use, in the order of the input, with all point and cell arrays.
 * `data` is a vtkUnstructuredGrid, a vtkPolyData, or a composite data set of these. Field data are
 * shared, but for a stamp: a filter cannot go on with a part of the cells. With AllDimensions the
 * result is `data`. Else `warn` tells of cells with points that do not exist, which are left out,
 * and, if `isWhole`, where cells have other dimensions only.
 */
vtkSmartPointer<vtkDataObject> TakeDimensions(vtkDataObject* data, int dimensions, bool isWhole,
  const std::function<void(const std::string&)>& warn);

}

#endif
