// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformCells.h
 * The output's cells: those of a level's children, whatever its solids are.
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
/// The same: octahedra around their shortest diagonals if `points`, those after the steps, are
/// known already; around any if they are null.
template <typename Id>
UniformCells MakeChildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, int steps,
  vtkDataArray* points, bool small);

/// Cells as they were read; `runs` those of the level that they are, `steps` steps below a control
/// level of tetrahedra, or negative in a scheme without octahedra.
UniformCells CopyCells(
  const SimplexList& cells, const std::vector<CellRun>& runs, int steps, bool small);

/// Turns octahedra to their shortest diagonal. Where that changes something and `shared` says that
/// others have these cells too, the connectivity is copied first.
void TurnOctahedra(UniformCells& cells, bool shared, vtkDataArray* points);

/// Simplices of dimension 0 to 2 among a level's cells after 0, 1 or 2 steps. `octahedra`: how many
/// cells of the level have a vertex in the middle then.
template <typename Id>
SimplexTuples GatherTuples(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  int steps, Id octahedra = 0);

}

#endif
