// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedShapes.h
 * The curved cells of VTK for each type of cell: where their nodes are, and their shape functions.
 */
#ifndef SubdivisionObjects_CurvedShapes_h
#define SubdivisionObjects_CurvedShapes_h

#include "Private/Roots/RootLattice.h"

#include "vtkCell.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

namespace subdivision
{

class CellJacobian;

enum class CurvedKind
{
  Quadratic, ///< VTK_QUADRATIC_EDGE and so on: nodes at corners and edges
  Lagrange   ///< VTK_LAGRANGE_CURVE and so on
};

struct CurvedShape
{
  CellShape Shape = CellShape::Vertex;
  int Order = 1;
  int CellType = 0; ///< of VTK
  /// In VTK's order, as multiples of 1 / Order; corners come first.
  std::vector<FrameNode> Nodes;
  /// Of each face of a solid, which of them it has, corners first.
  struct Face
  {
    int Corners;
    std::vector<int> Nodes;
  };
  std::vector<Face> Faces;
  vtkSmartPointer<vtkCell> Cell;                ///< one of this type, for its shape functions
  std::shared_ptr<const CellJacobian> Jacobian; ///< null: it is no solid

  int GetNumberOfNodes() const { return static_cast<int>(this->Nodes.size()); }
  /// Null if VTK has no such cell: octahedra, and pyramids of Lagrange. `order` counts for Lagrange
  /// only, 1 to 6.
  static const CurvedShape* Get(CellShape shape, CurvedKind kind, int order);
};

}

#endif
