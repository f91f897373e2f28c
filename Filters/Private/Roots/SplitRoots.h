// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SplitRoots.h
 * The cells of an earlier level, found again in a mesh that was split uniformly.
 *
 * The cells that a cell was split into follow one another, in an order that its type and the scheme
 * give. They are taken for its cells only if those that share points there share them here, too:
 * that tells the orders of the schemes apart, and the sides of polygons from quads.
 */
#ifndef SubdivisionObjects_SplitRoots_h
#define SubdivisionObjects_SplitRoots_h

#include "Private/Reading/CellReader.h"
#include "Private/Roots/RootLattice.h"

#include <functional>
#include <memory>
#include <vector>

namespace subdivision
{

/// A cell of the earlier level, or one that is no part of any.
struct Root
{
  vtkIdType First; ///< of its cells
  CellShape Shape;
  SplitOrder Order;
  int Steps;   ///< in which it was split: one less for a side of a face that has not four
  int Quarter; ///< an octahedron is four roots, as it is four cells
  const RootLattice* Lattice; ///< null: it is no part of any
};

/// Reads points of cells that were split.
class LatticeReader
{
public:
  explicit LatticeReader(vtkPointSet* mesh)
    : Cells(mesh)
  {
  }
  /// The point at a node of a cell that became the cells from `first` on; -1: it has none there.
  vtkIdType GetPoint(const RootLattice& lattice, vtkIdType first, const FrameNode& node) const;

protected:
  CellIds GetCell(vtkIdType cell) const
  {
    thread_local std::vector<vtkIdType> scratch;
    return this->Cells.GetCell(cell, scratch);
  }
  vtkIdType GetPointOfCorner(vtkIdType first, int corner) const
  {
    std::vector<vtkIdType> scratch; // mostly not used, and faster than one for each thread
    return this->Cells.GetCell(first + corner / 8, scratch).Ids[corner % 8];
  }

  CellReader Cells;
};

class SplitRoots : public LatticeReader
{
public:
  /// `steps`: how often the mesh was split. `accepts` tells which roots are wanted; the cells of
  /// others are roots that are no part of any.
  SplitRoots(
    vtkPointSet* mesh, int steps, const std::function<bool(const Root&)>& accepts = nullptr);

  vtkIdType GetNumberOfRoots() const { return static_cast<vtkIdType>(this->Roots.size()); }
  const Root& GetRoot(vtkIdType r) const { return this->Roots[r]; }
  vtkIdType GetPoint(const Root& root, const FrameNode& node) const
  {
    return this->LatticeReader::GetPoint(*root.Lattice, root.First, node);
  }
  /// Of the first cell of a root.
  unsigned char GetType(const Root& root) const { return this->Types[root.First]; }
  CellIds GetPoints(const Root& root) const { return this->GetCell(root.First); }

private:
  using Accepts = std::function<bool(const Root&)>;

  bool FindRoots(const Accepts& accepts, bool guesses);
  Root FindRoot(vtkIdType first, const Accepts& accepts, bool guesses);
  const RootLattice* GetLattice(CellShape shape, SplitOrder order, int steps);
  bool HasTypes(const Root& root) const;
  bool Fits(const Root& root) const;

  const int Steps;
  Buffer<unsigned char> Types;
  std::vector<Root> Roots;
  /// The order of the last root of each shape: neighbours have the same; -1: there was none.
  std::array<int, NumberOfShapes> Last{};
  /// Of each shape and order, after all steps and after one less.
  std::array<std::unique_ptr<RootLattice>, 2 * NumberOfShapes * NumberOfSplitOrders> Lattices;
  vtkDataArray* Octahedra; ///< which octahedron each cell is a piece of; may be null
};

}

#endif
