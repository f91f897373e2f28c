// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NonLinearCells.h
 * VTK's quadratic, cubic, Lagrange and Bezier cells as linear ones: by their corners, or cut along
 * their nodes.
 */
#ifndef SubdivisionObjects_NonLinearCells_h
#define SubdivisionObjects_NonLinearCells_h

#include "Private/Reading/CellReader.h"

#include "vtkCellType.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <map>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace subdivision
{

bool IsNonLinear(int cellType);

/// The linear cell at the corners of a non-linear one. The corners are its first points.
struct CornerCell
{
  int Type = 0;
  vtkIdType Size = 0;
};
/// Size is 0 where the cell has fewer points.
CornerCell GetCornerCell(int cellType, vtkIdType size);

/// A linear cell on some nodes of a non-linear one.
struct CellPiece
{
  /// Six nodes of an octahedron: 0 and 1, 2 and 3, 4 and 5 are opposite; (0, 1, 2, 4) is a positive
  /// tetrahedron.
  static constexpr int Octahedron = -1;

  int Type = 0; ///< of VTK, or Octahedron
  int Size = 0;
  std::array<int, 8> Nodes{};
};

/**
 * How a cell is cut. Pieces of a solid that are triangles or quads are its faces, which look
 * outwards: each makes a cone with the centre.
 */
struct CellPieces
{
  /// Of a solid: the node that is its centre; -1 if there is none, so that the mean of all nodes is
  /// the centre.
  int Centre = -1;
  int Dimension = 0;
  std::vector<CellPiece> Pieces;
};

/// Calls visit(type, points) for the pieces of a cell, whose points live until it returns.
template <typename Visit>
void ForEachPiece(const CellPieces& table, const CellIds& cell, const Visit& visit)
{
  for (const CellPiece& piece : table.Pieces)
  {
    vtkIdType ids[8];
    CellIds part;
    part.Size = piece.Size;
    if (piece.Type == VTK_POLYGON) // its nodes are the last ones of the cell
    {
      part.Ids = cell.Ids + cell.Size - piece.Size;
    }
    else
    {
      part.Ids = ids;
      for (int i = 0; i < piece.Size; ++i)
      {
        ids[i] = cell.Ids[piece.Nodes[i]];
      }
    }
    visit(piece.Type, part);
  }
}

/**
 * Cuts non-linear cells. A face is cut by its own nodes alone, so that cells fit together which
 * share all nodes of a face. Cells with a full lattice of nodes become the cells of the lattice, an
 * element of order n in d dimensions n^d of them. Where a quadratic face has no node in its middle,
 * its corners are cut off, and where it has one, and is a triangle, six triangles are around it;
 * the inside of such a cell is cut from its centre. Each task needs an object of its own, which
 * keeps the tables that it made.
 */
class NonLinearCells
{
public:
  explicit NonLinearCells(vtkPointSet* input);

  /// Null if a cell of this type cannot have this number of points. The result lives as long as the
  /// object.
  const CellPieces* Find(int cellType, vtkIdType cellId, vtkIdType size);

private:
  using Orders = std::array<int, 3>;
  using Key = std::array<int, 5>; ///< type, number of points, orders

  Orders FindOrders(int cellType, vtkIdType cellId, vtkIdType size) const;

  vtkSmartPointer<vtkDataArray> Degrees; ///< HigherOrderDegrees, or null
  std::map<Key, CellPieces> Tables;
};

}

#endif
