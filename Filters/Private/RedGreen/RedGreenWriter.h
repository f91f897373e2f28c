// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenWriter.h
 * The cells of a refined mesh, and their arrays.
 */
#ifndef SubdivisionObjects_RedGreenWriter_h
#define SubdivisionObjects_RedGreenWriter_h

#include "Private/RedGreen/RedGreenMesh.h"
#include "Private/Run/RunOptions.h"

#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

/// Writes cells and cell data. `mesh` was read from `input`. `simplices` gets the simplex of the
/// mesh of which each cell is a part; null: it is not wanted. `pointsMove`: see CellArrayOptions.
/// Warns of arrays of the input that are replaced.
template <typename Id>
void WriteRedGreenCells(const RedGreenOutput<Id>& plan, vtkPointSet* input,
  const RedGreenMesh& mesh, const RunOptions& run, bool pointsMove,
  std::vector<vtkIdType>* simplices, vtkUnstructuredGrid* output);

}

#endif
