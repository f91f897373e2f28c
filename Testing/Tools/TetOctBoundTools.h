// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctBoundTools.h
 * Where the points of VolumeScheme = TetOct lie in the cells of a level before, written down from
 * the definition (Mathematics 10), and comparisons of bounds with the limit there.
 */
#ifndef SubdivisionObjects_TetOctBoundTools_h
#define SubdivisionObjects_TetOctBoundTools_h

#include "BoundTools.h"

namespace bound_tools
{

/// A tetrahedron or an octahedron.
struct TetOctSolid
{
  vtkIdType Cell;            ///< its first cell in the mesh; an octahedron has four
  std::size_t Of;            ///< the solid of a level before in which it lies
  Ids Points;                ///< four, or six: opposite ones side by side
  std::vector<Point> Places; ///< of the points, in that solid
  bool IsOct() const { return this->Points.size() == 6; }
};

/// The tetrahedra of a control mesh: `Of` is the cell, and a place says the weights of its corners
/// but the first.
std::vector<TetOctSolid> ListControlTets(vtkUnstructuredGrid* control);
/// What one step made of those of a mesh.
std::vector<TetOctSolid> SplitTetOct(
  const std::vector<TetOctSolid>& solids, vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* next);
/// Each is itself the one in which it lies: a tetrahedron has places as in ListControlTets, an
/// octahedron has its points at 1 and -1 of each axis.
std::vector<TetOctSolid> Restart(std::vector<TetOctSolid> solids);

/// The points of fine solids in the cells of the mesh in whose solids they lie.
PlacedPoints PlaceTetOctPoints(vtkUnstructuredGrid* coarse, const std::vector<TetOctSolid>& solids,
  const std::vector<TetOctSolid>& fine);

/// The solids after some levels.
std::vector<TetOctSolid> FindTetOctSolids(
  vtkDataObject* input, int levels, const Configure& configure = {});

/// Expects that bounds hold at all points of so many further steps, as ExpectBounds.
void ExpectTetOctBounds(vtkDataObject* input, int levels, int steps, const Configure& configure,
  bool projects, Tightness& tightness);

}

#endif
