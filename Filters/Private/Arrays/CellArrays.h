// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellArrays.h
 * Copies cell data from the cells of the input to their children.
 */
#ifndef SubdivisionObjects_CellArrays_h
#define SubdivisionObjects_CellArrays_h

#include "Core/Memory/Buffer.h"
#include "Private/Reading/CellsToSimplices.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkIdTypeArray;
class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct CellArrayOptions
{
  int Levels = 0;
  /// Whether children do not lie in their parents: then the input's normals do not hold for them,
  /// and are left out.
  bool PointsMove = false;
  /// Adds the cell array `vtkOriginalCellIds`, unless `CarryOriginalIds` says that the input has it
  /// from an earlier filter: then it is copied like other arrays. Children get the global ids of
  /// their cell, as an array that is not marked as global ids.
  bool OriginalIds = false;
  bool CarryOriginalIds = false;
  /// Arrays that the filter makes itself: the input's are left out.
  std::vector<std::string> Replaced;
  /// Is told which arrays cannot be used.
  std::function<void(const std::string&)> Warn;
};

/// The values of a cell array for the children that the simplices have after some levels.
vtkSmartPointer<vtkAbstractArray> SpreadToChildren(
  vtkAbstractArray* array, const SimplicesOfCells& cells, int levels);

/// Whether `sources` are all of `size` cells in their order.
bool AreAllCells(Row<vtkIdType> sources, vtkIdType size);

/// Copies all cell arrays of the input. `spread` makes an array of the output from one of the
/// input; `makeIds` makes the array of the input cell that each output cell comes from; `areSame`
/// says whether the cells are still cells of the input.
void CopyCellArrays(vtkPointSet* input, const CellArrayOptions& options,
  const std::function<vtkSmartPointer<vtkAbstractArray>(vtkAbstractArray*)>& spread,
  const std::function<vtkSmartPointer<vtkAbstractArray>()>& makeIds,
  const std::function<bool()>& areSame, vtkPointSet* output);

/// Copies every cell array of `input` to the children that its simplices have after some levels.
void CopyCellArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const CellArrayOptions& options, vtkUnstructuredGrid* output);

/// The same for an output where `sources` has, for each cell, the input cell that it is a part of.
/// `sources` itself becomes `vtkOriginalCellIds`.
void CopyCellArrays(vtkPointSet* input, vtkIdTypeArray* sources, const CellArrayOptions& options,
  vtkPointSet* output);

/// The same where a child may take its values from another cell than its parent: `parents` has this
/// cell for each child of the first step. Empty: all children take the values of their parent.
void CopyCellArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const std::vector<vtkIdType>& parents, const CellArrayOptions& options,
  vtkUnstructuredGrid* output);

/// Adds a cell array that has one value for all children of each simplex.
void AddValuesOfSimplices(const unsigned char* values, const SimplexList& simplices, int levels,
  const char* name, vtkPointSet* input, vtkUnstructuredGrid* output);

/// Subtracts `levels` from the sharpness of lines and triangles, down to 0: the rest of it after so
/// many steps.
void ReduceSharpness(const char* name, int levels, vtkUnstructuredGrid* output);

/// Derives the ghost types of points from the types of cells: a point is a duplicate if all of its
/// cells are. A point without cells keeps its type. Does nothing without ghost types.
void RebuildPointGhosts(vtkPointSet* input, vtkPointSet* output);

}

#endif
