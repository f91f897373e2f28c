// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformCells.h
 * Makes the cells of the output: the children of the cells of a level, in any volume scheme.
 */
#ifndef SubdivisionObjects_UniformCells_h
#define SubdivisionObjects_UniformCells_h

#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Strata/Singularities.h"
#include "Private/Reading/SolidOrientation.h"

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
  KnownSigns Signs; ///< of the volumes
};

/// A level's cells after 1 or 2 steps, or as many as Scheme::WriteChildren can; `runs` are its
/// runs. `small`: with 32-bit ids where they fit. `points` are the points after the steps, and only
/// pieces depend on them: octahedra are cut around their shortest diagonal, or, if `points` is
/// null, around any, for TurnOctahedra.
template <typename Scheme>
UniformCells MakeChildren(const typename Scheme::Level& level, const std::vector<CellRun>& runs,
  int steps, vtkDataArray* points, bool small);

/// Copies cells as they were read. `runs`: of their level. `steps`: number of steps behind this
/// level in a scheme with pieces, negative in others.
UniformCells CopyCells(
  const SimplexList& cells, const std::vector<CellRun>& runs, int steps, bool small);

/// Cuts octahedra around their shortest diagonals. If that changes cells and `shared` says that
/// other outputs have them too, the connectivity is copied first.
void TurnOctahedra(UniformCells& cells, bool shared, vtkDataArray* points);

/// The simplices of dimension 0 to 2 in `runs` of a level after 0, 1 or 2 steps, or after any
/// number where there is nothing but vertices and edges. `centres`: number of vertices of the next
/// level inside solids.
template <typename Id>
SimplexTuples GatherTuples(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int steps, Id centres);

}

#endif
