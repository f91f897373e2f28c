// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedCells.h
 * Red refinement that keeps the types of cells: a hexahedron becomes eight hexahedra, a wedge eight
 * wedges, a pyramid six pyramids and four tetrahedra, a quad four quads (Mathematics 2). New points
 * lie in the middle of edges, of quads and of hexahedra. Cells that share an edge or a quad share
 * its middle, so that nothing hangs.
 */
#ifndef SubdivisionObjects_RedCells_h
#define SubdivisionObjects_RedCells_h

#include "Core/Operators/SparseRows.h"

#include <array>
#include <vector>

namespace subdivision
{

/// Their corners are in the order of VTK.
enum class CellShape : unsigned char
{
  Vertex,
  Line,
  Triangle,
  Quad,
  Tet,
  Pyramid,
  Wedge,
  Hex
};
constexpr int NumberOfShapes = 8;

int GetNumberOfCorners(CellShape shape);

struct ShapedCells
{
  long long NumberOfPoints = 0;
  std::vector<CellShape> Shapes;
  std::vector<long long> Corners; ///< of one cell after the other

  void Add(CellShape shape, const long long* corners);
};

/// How many cells of each shape there are after a step.
std::array<double, NumberOfShapes> CountRedChildren(
  const std::array<double, NumberOfShapes>& cells);

/// One step.
struct RedStep
{
  ShapedCells Children;           ///< the children of a cell follow one another
  std::vector<vtkIdType> Parents; ///< of each child
  SparseRows<long long> Rows;     ///< old points stay, new ones are means of corners
};

/// A tetrahedron is split around the diagonal between the middles of its edges 02 and 13.
RedStep RefineRed(const ShapedCells& cells);

}

#endif
