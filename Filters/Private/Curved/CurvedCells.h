// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedCells.h
 * Writes a mesh on the limit as curved cells of VTK, for solvers.
 */
#ifndef SubdivisionObjects_CurvedCells_h
#define SubdivisionObjects_CurvedCells_h

#include "Private/Curved/CurvedNodes.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;

namespace subdivision
{

class Exchange;

struct CurvedOptions
{
  CurvedKind Kind = CurvedKind::Quadratic;
  int Order = 2;
  bool Use32BitIds = false;
  Exchange* Ranks = nullptr; ///< that have parts of the mesh; null: nothing is proved
  bool AreMade = false;      ///< cells have their nodes (SetCells)
  /// Null, or the nodes of cells that have CurvedCellName: their nodes are no points of the mesh.
  const std::vector<CurvedNodes>* Kept = nullptr;
  std::function<void(const std::string&)> Warn;
  std::function<void(const std::string&)> Fail;
};

/// Whether the nodes of an order are points of further levels, and of how many.
constexpr bool AreNodesOnLevels(int order)
{
  return order == 1 || order == 2 || order == 4;
}
constexpr int CountStepsOfNodes(int order)
{
  return order == 2 ? 1 : order == 4 ? 2 : 0;
}

/**
 * Makes a grid of curved cells of a mesh on the limit, or of each mesh of a composite data set.
 * Each cell of the level CountStepsOfNodes before becomes one cell, whose nodes are the points that
 * divide its edges, faces and inside evenly in parameters: so nodes are shared as points are. An
 * octahedron becomes four tetrahedra around its shortest diagonal. Cells take the data of their
 * first child; points that are no nodes are left out. With `Kept` and `AreMade` the mesh is the
 * level itself. Field data are shared, but for a stamp. All ranks call this together.
 */
vtkSmartPointer<vtkDataObject> MakeCurvedCells(vtkDataObject* data, const CurvedOptions& options);

}

#endif
