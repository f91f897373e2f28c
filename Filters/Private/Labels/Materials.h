// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Materials.h
 * What a table says of materials.
 */
#ifndef SubdivisionObjects_Materials_h
#define SubdivisionObjects_Materials_h

#include <string>
#include <vector>

class vtkDataSetAttributes;
class vtkFieldData;

namespace subdivision
{

/// Adds all columns of `table` to `fields`, and those of numbers to `cells`: the row of each cell's
/// material. A row is for the label in the column `name`, else in the column `Label`, else for that
/// of its own number. `labels`: all labels; `cellLabels`: of each cell the place there, plus 1.
/// Returns a warning if a label has no row; the values of its cells are 0.
std::string AddMaterials(vtkFieldData* table, const std::string& name,
  const std::vector<double>& labels, const std::vector<int>& cellLabels,
  vtkDataSetAttributes* cells, vtkFieldData* fields);

/// Whether there is a column for labels.
bool IsMaterialTable(vtkFieldData* table, const std::string& name);

}

#endif
