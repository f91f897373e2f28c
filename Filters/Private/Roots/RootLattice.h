// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RootLattice.h
 * The lattice of a cell that was split some times, and which of its cells have its points.
 */
#ifndef SubdivisionObjects_RootLattice_h
#define SubdivisionObjects_RootLattice_h

#include "Core/Cells/CellShapes.h"
#include "Core/Memory/Buffer.h"

#include "vtkCellType.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace subdivision
{

/// A place on a lattice that divides the edges of a cell: multiples along the axes of CellFrames.h.
/// The first corner of each diagonal of an octahedron is the one with the positive multiple.
using FrameNode = std::array<int, 3>;

/// Where the corners of a cell are, for so many divisions of its edges.
std::array<FrameNode, 8> GetCornerNodes(CellShape shape, int divisions);

/// The VTK type of each shape; octahedra have none.
constexpr std::array<unsigned char, NumberOfShapes> TypesOfShapes = { VTK_VERTEX, VTK_LINE,
  VTK_TRIANGLE, VTK_QUAD, VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_EMPTY_CELL };

/// In which order steps write children: of simplices and of the quads of surfaces, of tetrahedra
/// and octahedra, or of cells that keep their types.
enum class SplitOrder
{
  Simplices,
  TetOct,
  Hybrid
};
constexpr int NumberOfSplitOrders = 3;

/// One of the cells that a cell was split into. An octahedron is written as four tetrahedra.
struct LatticeCell
{
  CellShape Shape;
  int First; ///< of the cells that it is written as
  std::array<FrameNode, 8> Corners;
};
/// Calls act(cell) for all cells after some steps, in the order in which they are written.
void ForLatticeCells(
  CellShape shape, SplitOrder order, int steps, const std::function<void(const LatticeCell&)>& act);
std::vector<LatticeCell> ListLatticeCells(CellShape shape, SplitOrder order, int steps);

class RootLattice
{
public:
  RootLattice(CellShape shape, SplitOrder order, int steps);

  /// A corner of a cell as one number.
  static int ToCorner(int cell, int corner) { return 8 * cell + corner; }
  /// Which corner of which cell a point is. A point that only an octahedron has, in an order of its
  /// own, is -2 - the place of that in GetOctahedra.
  int GetCorner(const FrameNode& node) const { return this->Corners[this->Index(node)]; }
  const std::vector<LatticeCell>& GetOctahedra() const { return this->Octahedra; }
  /// The VTK type of each cell.
  const std::vector<unsigned char>& GetTypes() const { return this->Types; }
  /// Pairs of corners that have one point if this is how the cell was split.
  const std::vector<std::pair<int, int>>& GetEqualCorners() const { return this->EqualCorners; }

private:
  int Index(const FrameNode& node) const
  {
    return node[0] - this->Low +
      this->Width * (node[1] - this->Low + this->Width * (node[2] - this->Low));
  }

  int Low;   ///< the smallest multiple
  int Width; ///< how many multiples there are along an axis
  Buffer<int> Corners;
  std::vector<LatticeCell> Octahedra;
  std::vector<unsigned char> Types;
  std::vector<std::pair<int, int>> EqualCorners;
};

}

#endif
