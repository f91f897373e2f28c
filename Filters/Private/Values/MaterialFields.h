// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MaterialFields.h
 * Values that jump where materials meet: each material has a field of its own, and a point where
 * several meet has a copy for each of them.
 *
 * The work of a filter knows nothing of it. Before the work, materials get colours, different ones
 * if they have points of one cell, and each array of the points becomes one array for each colour
 * (see FieldName in ArrayNames.h). The last component is a weight, 1 at the points of materials of
 * that colour and 0 elsewhere; PointArrays divides by it after each operator. So a row takes values
 * of its own material only, in the proportions that it has for points. After the work, the points
 * get copies, and each copy takes its values from the array of its colour.
 */
#ifndef SubdivisionObjects_MaterialFields_h
#define SubdivisionObjects_MaterialFields_h

#include "Private/Run/RunOptions.h"

#include <functional>
#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

/// The cell array of the block whose values a cell has where blocks have different ones at points
/// that they share; 0: a block that has none of its own. It is there before the work only.
constexpr const char* OwnBlockName = "SubdivisionOwnBlock";

struct MaterialFieldOptions
{
  /// If not, the work is done, with a warning if there are copies, but for an input with the array
  /// OwnBlockName: its blocks have such fields, if there are not too many.
  bool IsOn = false;
  /// Cell arrays of these names become fields too: the value at a point is the mean of the cells of
  /// a material around it.
  std::vector<std::string> CellArrays;
  bool OfMergedParts = false; ///< materials are the values of the cell array MergedPartsName
};

/**
 * Calls work(mesh, output) for `input`, whose material is options.Features.Material, as described
 * above. Copies of points that an earlier filter made (the point array MaterialPointIds) are one
 * point for the work. If other partitions have parts of the mesh, all call this together.
 *
 * A material has a value at the points of its cells, but for cells that are faces of others: these
 * take the values of a material that all of their points have. In the output the copies follow
 * after all points, and MaterialPointIds says which point each is. Returns false, after an error,
 * if the work does, or more than 32 colours are needed. Takes about as much memory for arrays as
 * one array for each colour; the time is linear in the size of input and output.
 */
bool RunWithMaterialFields(vtkPointSet* input, vtkPointSet* output, RunOptions& options,
  const MaterialFieldOptions& fields, const std::function<bool(vtkPointSet*, vtkPointSet*)>& work);

}

#endif
