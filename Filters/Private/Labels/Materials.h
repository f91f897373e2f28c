// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Materials.h
 * The columns of a table of materials, as arrays.
 */
#ifndef SubdivisionObjects_Materials_h
#define SubdivisionObjects_Materials_h

#include "vtkVariant.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataSetAttributes;
class vtkFieldData;

namespace subdivision
{

/// Adds all columns of `table` to `fields`, and columns of numbers to `cells`: the row of each
/// cell's material. A row is for the label in the column `name`, else in the column `Label`, else
/// for the label that equals its number. `labels`: all labels; `cellLabels`: of each cell the
/// position there, plus 1. `warn` is told of a label without a row, whose cells get zeros, of one
/// with several rows, the first of which counts, of a column of labels that has no numbers, and of
/// arrays of `cells` that columns replace.
void AddMaterials(vtkFieldData* table, const std::string& name,
  const std::vector<vtkVariant>& labels, const std::vector<int>& cellLabels,
  vtkDataSetAttributes* cells, vtkFieldData* fields,
  const std::function<void(const std::string&)>& warn);

/// Whether there is a column for labels.
bool IsMaterialTable(vtkFieldData* table, const std::string& name);

}

#endif
