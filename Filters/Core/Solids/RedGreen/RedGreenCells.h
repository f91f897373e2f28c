// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenCells.h
 * Types of red-green refinement: leaves, cells of the forest, output cells, and origins of
 * vertices.
 */
#ifndef SubdivisionObjects_RedGreenCells_h
#define SubdivisionObjects_RedGreenCells_h

#include "Core/Memory/SimplexList.h"

#include <array>

namespace subdivision
{

/// The largest level: levels are stored in one byte.
constexpr int LastLevel = 255;

/// How a cell of the output came into being; the values of the cell array `RefinementKind`.
enum class RefinementKind : unsigned char
{
  Untouched = 0, ///< a cell of the input as it was, of level 0
  Red = 1,       ///< a red child, also an unsplit input cell that an earlier filter made as one
  GreenI = 2,    ///< one edge split; triangles too
  GreenII = 3,   ///< two opposite edges
  GreenIII = 4   ///< the edges of one face
};

/// How a state treats an input cell, if the input is a part of a larger mesh.
enum class CellScope : unsigned char
{
  Ignored = 0, ///< stays as it is, whatever happens around it
  Copied = 1,  ///< is split, but is not among the cells that are counted
  Own = 2
};

/// A cell that is not red: the tree cell itself, or a child of a red one that need not be stored.
template <typename Id>
struct RedGreenLeaf
{
  Id Cell = 0;    ///< < number of input cells: a cell of the input; else a red child
  int Child = -1; ///< -1: the cell itself; else this child of the cell (Simplices.h)
};

/// A cell of the forest.
template <typename Id>
struct RedGreenCell
{
  Id Input = 0;   ///< the input cell at the root of its tree
  Id Parent = -1; ///< tree cell; -1: it is a cell of the input
  int Child = -1; ///< which child of its parent
  int Dimension = 0;
  int Level = 0; ///< the level of the input cell, plus the steps from there
  std::array<Id, 4> Vertices{ { -1, -1, -1, -1 } };
};

/// A cell of the output as it would be now.
template <typename Id>
struct RedGreenOutputCell
{
  RedGreenLeaf<Id> Leaf; ///< that it is, or is a green part of
  Id Input = 0;          ///< the input cell at the root of its tree
  int Dimension = 0;
  int Level = 0; ///< of the leaf
  RefinementKind Kind = RefinementKind::Untouched;
  std::array<Id, 4> Vertices{ { -1, -1, -1, -1 } };
};

/// The edge of a tree cell whose midpoint a vertex is.
template <typename Id>
struct RedGreenOrigin
{
  Id Cell = 0;
  int Edge = 0; ///< as in triangle::EdgeVertices, tetrahedron::EdgeVertices; 0 for lines
};

template <typename Id>
class RedGreen;
template <typename Id>
class RedGreenOutput;

}

#endif
