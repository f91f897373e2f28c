// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenOutput.h
 * The output of red-green refinement: its cells, where leaves with split edges are cut into green
 * parts; a list of these leaves; and the rows that put new vertices at midpoints.
 */
#ifndef SubdivisionObjects_RedGreenOutput_h
#define SubdivisionObjects_RedGreenOutput_h

#include "Core/Operators/SparseRows.h"
#include "Core/Operators/VertexRow.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/RedGreen/RedGreen.h"

namespace subdivision
{

/// The arrays that receive the output; RedGreenOutput::GetCounts() tells their sizes. Arrays other
/// than Cells may be null and are not written then.
template <typename Out>
struct RedGreenStorage
{
  CellStorage<Out> Cells{ nullptr, nullptr, nullptr };
  unsigned char* Levels = nullptr;   ///< of the leaf that a cell is, or is a green part of
  unsigned char* Kinds = nullptr;    ///< RefinementKind
  vtkIdType* GreenParents = nullptr; ///< argument for GetGreenLeaf(), -1: no green part
  vtkIdType* InputCells = nullptr;   ///< of which each cell is a part
};

/// A leaf that the output has cut into green parts. The next filter replaces the parts by the leaf
/// and its midpoints (RedGreen::AddMidpoint).
template <typename Id>
struct GreenLeaf
{
  Id Input = 0; ///< the input cell that it is a part of
  int Dimension = 0;
  int Level = 0;
  vtkIdType FirstCell = 0; ///< its parts are these cells of the output
  int NumberOfCells = 0;
  std::array<Id, 4> Vertices{ { -1, -1, -1, -1 } };
  std::array<Id, 6> Midpoints{ { -1, -1, -1, -1, -1, -1 } }; ///< of its edges (Simplices.h); -1
};

/**
 * Computes the positions of all output cells of a state, which must not change while this object is
 * used. Cells have the order of their input cells; the children of a cell are consecutive, in the
 * order of Simplices.h. A green part is its leaf with midpoints in the places of some vertices, and
 * so has the orientation of the leaf.
 */
template <typename Id>
class RedGreenOutput
{
public:
  explicit RedGreenOutput(const RedGreen<Id>& state);

  CellCounts GetCounts() const { return this->Counts; }
  vtkIdType GetNumberOfGreenLeaves() const { return this->Greens.size(); }
  GreenLeaf<Id> GetGreenLeaf(vtkIdType i) const;

  template <typename Out>
  void Write(const RedGreenStorage<Out>& storage) const;

private:
  /// A leaf of a tree with split edges, or a red cell whose children are not stored.
  struct Leaf
  {
    Id Node;
    vtkIdType FirstCell;
    vtkIdType FirstEntry;
    vtkIdType Green; ///< its number among the leaves with green parts, or -1
  };
  /// A tree with split edges. Cells to Greens are first its counts, and after PlaceTrees the
  /// positions where it starts.
  struct Tree
  {
    Id Root;
    Id Input;
    vtkIdType Cells;
    vtkIdType Entries;
    vtkIdType Leaves;
    vtkIdType Greens;
  };
  void FindTrees();
  void CountLeaves(Id node, Tree& tree) const;
  void PlaceTrees();
  void PlaceLeaves(Id node, Tree& next);
  template <typename Out>
  void WriteLeaf(const Leaf& leaf, const RedGreenStorage<Out>& storage) const;

  const RedGreen<Id>& State;
  CellCounts Counts;
  Buffer<Tree> Trees; ///< in input order
  Buffer<Leaf> Leaves;
  Buffer<vtkIdType> Greens; ///< the leaves that have green parts
};

/// The operator of Placement `Linear`: input vertices stay, and new vertices are means of input
/// vertices. The weights are multiples of powers of 1/2, and so exact. A row has up to four
/// entries, or up to seven if the input has midpoints (RedGreen::AddMidpoint).
template <typename Id>
struct MidpointRows : PointOperator
{
  SparseRows<Id> Added;

  vtkIdType GetNumberOfColumns() const override { return this->Added.NumberOfColumns; }
  vtkIdType GetNumberOfRows() const override
  {
    return this->Added.NumberOfColumns + this->Added.GetNumberOfRows();
  }
  void ForEachBlock(const User& use) const override;
};

/// `ends`: of each midpoint, after `inputs` vertices. Then come means of all these.
template <typename Id>
MidpointRows<Id> MakeRowsOfMidpoints(Id inputs, const std::vector<std::array<Id, 2>>& ends,
  const std::vector<WeightedVertices>& means = {});

/// The ends of the midpoints of a state.
template <typename Id>
std::vector<std::array<Id, 2>> ListEnds(const RedGreen<Id>& state)
{
  const Id inputs = state.GetNumberOfInputVertices();
  std::vector<std::array<Id, 2>> ends(state.GetNumberOfVertices() - inputs);
  ForEach(static_cast<vtkIdType>(ends.size()),
    [&](vtkIdType i) { ends[i] = state.GetEnds(static_cast<Id>(inputs + i)); });
  return ends;
}

template <typename Id>
MidpointRows<Id> MakeMidpointRows(const RedGreen<Id>& state)
{
  return MakeRowsOfMidpoints(state.GetNumberOfInputVertices(), ListEnds(state));
}

}

#endif
