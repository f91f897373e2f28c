// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformCells.h
 * Makes the cells of the output: the children of the cells of a level, in either volume scheme.
 */
#ifndef SubdivisionObjects_UniformCells_h
#define SubdivisionObjects_UniformCells_h

#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/Strata/Singularities.h"
#include "Core/Solids/TetOct/TetOctComplex.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

class vtkDataArray;

namespace subdivision
{

struct UniformCells
{
  vtkSmartPointer<vtkCellArray> Cells;
  vtkSmartPointer<vtkUnsignedCharArray> Types;
  /// The octahedron that each cell is a piece of, -1 for none; null in a scheme without octahedra.
  vtkSmartPointer<vtkIdTypeArray> Octahedra;
};

/// A level's cells after 1 or 2 steps; `runs` are those of the level. `small`: with 32-bit ids
/// where they fit.
template <typename Id>
UniformCells MakeChildren(
  const Level<Id>& level, const std::vector<CellRun>& runs, int steps, bool small);
/// The same for the tet/oct scheme. Octahedra are cut around their shortest diagonal if `points`,
/// those after the steps, are given; if they are null, around any diagonal, for TurnOctahedra.
template <typename Id>
UniformCells MakeChildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, int steps,
  vtkDataArray* points, bool small);

/// Copies cells as they were read. `runs`: those of their level. `steps`: number of steps behind
/// this level in the tet/oct scheme, negative in the other one.
UniformCells CopyCells(
  const SimplexList& cells, const std::vector<CellRun>& runs, int steps, bool small);

/// Cuts octahedra around their shortest diagonals. If that changes cells and `shared` says that
/// other outputs have them too, the connectivity is copied first.
void TurnOctahedra(UniformCells& cells, bool shared, vtkDataArray* points);

/// The simplices of dimension 0 to 2 in `runs` of a level after 0, 1 or 2 steps. `octahedra`:
/// number of octahedra of the level, whose centres are vertices after two steps.
template <typename Id>
SimplexTuples GatherTuples(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  int steps, Id octahedra = 0);

}

#endif
