// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditWeights.h
 * How much of an edit each point and cell takes part in.
 */
#ifndef SubdivisionObjects_EditWeights_h
#define SubdivisionObjects_EditWeights_h

#include "Core/Memory/Buffer.h"
#include "Private/Edit/EditMesh.h"

namespace subdivision
{

/// 1 for each point that is selected or has a selected cell.
Buffer<unsigned char> FindEditedPoints(vtkPointSet* mesh, const SelectedParts* selected);

/// 1 for each cell that is selected, or all of whose points are.
Buffer<unsigned char> FindEditedCells(
  vtkPointSet* mesh, const SelectedParts* selected, const Buffer<unsigned char>& points);

/// The mean length of the edges at selected points; 1 where there are none.
double FindMeanLength(vtkPointSet* mesh, const Buffer<unsigned char>& points);

/// The weight of each point: 1 at selected points, and 0 from `radius` on.
Buffer<double> FindWeights(vtkPointSet* mesh, const Buffer<unsigned char>& points, double radius,
  const EditOptions& options);

/// The weight of each cell: 1 for an edited cell; else the mean of its points, 0 without a radius.
Buffer<double> FindCellWeights(vtkPointSet* mesh, const Buffer<unsigned char>& cells,
  const Buffer<double>& weights, double radius);

}

#endif
