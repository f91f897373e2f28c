// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenCells.h
 * Types of red-green refinement: leaves, cells of the forest, output cells, origins of vertices,
 * and positions in the connectivity of cells of mixed dimension.
 */
#ifndef SubdivisionObjects_RedGreenCells_h
#define SubdivisionObjects_RedGreenCells_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/SimplexList.h"

#include <array>
#include <cstring>

namespace subdivision
{

/// The largest level: levels are stored in one byte.
constexpr int LastLevel = 255;

/// The positions in the connectivity where simplices start. They are stored for each block of
/// simplices only; if all simplices have one dimension none is stored.
class SimplexPlaces
{
public:
  static constexpr vtkIdType SimplicesPerBlock = 64;

  SimplexPlaces() = default;
  explicit SimplexPlaces(const SimplexView& cells)
    : Dimensions(cells.Dimensions)
    , Corners(FindCorners(cells))
  {
    if (this->Corners > 0)
    {
      return;
    }
    this->Starts =
      Buffer<vtkIdType>((cells.NumberOfSimplices + SimplicesPerBlock - 1) / SimplicesPerBlock + 1);
    ForEach(this->Starts.size() - 1,
      [&](vtkIdType block)
      {
        const vtkIdType first = block * SimplicesPerBlock;
        this->Starts[block] =
          this->Sum(first, std::min(cells.NumberOfSimplices, first + SimplicesPerBlock));
      });
    CountsToOffsets(this->Starts);
  }
  vtkIdType operator[](vtkIdType simplex) const
  {
    if (this->Corners > 0)
    {
      return simplex * this->Corners;
    }
    const vtkIdType block = simplex / SimplicesPerBlock;
    return this->Starts[block] + this->Sum(block * SimplicesPerBlock, simplex);
  }

private:
  vtkIdType Sum(vtkIdType begin, vtkIdType end) const
  {
    int entries = 0;
    for (vtkIdType i = begin; i < end; ++i)
    {
      entries += this->Dimensions[i] + 1;
    }
    return entries;
  }
  /// How many corners each simplex has; 0 where they differ.
  static vtkIdType FindCorners(const SimplexView& cells)
  {
    const vtkIdType size = cells.NumberOfSimplices;
    const unsigned char* first = cells.Dimensions;
    const bool same =
      size > 0 && std::memcmp(first + 1, first, static_cast<std::size_t>(size - 1)) == 0;
    return same ? *first + 1 : 0;
  }
  const unsigned char* Dimensions = nullptr;
  vtkIdType Corners = 0;
  Buffer<vtkIdType> Starts;
};

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
