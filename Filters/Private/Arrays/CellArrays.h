// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellArrays.h
 * Cell data go to the children.
 */
#ifndef SubdivisionObjects_CellArrays_h
#define SubdivisionObjects_CellArrays_h

#include "Core/Memory/Buffer.h"
#include "Private/Reading/CellsToSimplices.h"

#include <functional>
#include <string>
#include <vector>

class vtkIdTypeArray;
class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct CellArrayOptions
{
  int Levels = 0;
  /// Output `vtkOriginalCellIds`; `CarryOriginalIds`: the input has them from an earlier filter.
  bool OriginalIds = false;
  bool CarryOriginalIds = false;
  /// Arrays that the filter makes itself: the input's are left out.
  std::vector<std::string> Replaced;
  /// Is told which arrays cannot be used.
  std::function<void(const std::string&)> Warn;
};

/// Copies every cell array of `input` to the children that its simplices have after some levels.
/// Global and pedigree ids are dropped.
void CopyCellArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const CellArrayOptions& options, vtkUnstructuredGrid* output);

/// The same where `sources` tells of each output cell the input cell that it is a part of; it
/// becomes `vtkOriginalCellIds` itself.
void CopyCellArrays(vtkPointSet* input, vtkIdTypeArray* sources, const CellArrayOptions& options,
  vtkUnstructuredGrid* output);

/// The same where some children, `parents` one for each child of the first step, take the values of
/// another simplex than their own parent; none: all take those of their parent.
void CopyCellArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const std::vector<vtkIdType>& parents, const CellArrayOptions& options,
  vtkUnstructuredGrid* output);

/// Adds a cell array that has one value for all children of each simplex.
void AddValuesOfSimplices(const unsigned char* values, const SimplexList& simplices, int levels,
  const char* name, vtkPointSet* input, vtkUnstructuredGrid* output);

/// Takes `levels` from the sharpness that lines carry, down to 0.
void ReduceSharpness(const char* name, int levels, vtkUnstructuredGrid* output);

/// Point ghost types from the cells': a point is a duplicate if all of its cells are. Does nothing
/// if the input has no ghost types.
void RebuildPointGhosts(vtkPointSet* input, vtkPointSet* output);

}

#endif
