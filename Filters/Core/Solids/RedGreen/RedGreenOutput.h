// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenOutput.h
 * The output of red-green refinement: cells with their green children, in input order; the leaves
 * that have green children; the rows that put new vertices at midpoints.
 */
#ifndef SubdivisionObjects_RedGreenOutput_h
#define SubdivisionObjects_RedGreenOutput_h

#include "Core/Operators/SparseRows.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/RedGreen/RedGreen.h"

namespace subdivision
{

/// Where the cells go. Null: not wanted. Sizes: RedGreenOutput::GetCounts().
template <typename Out>
struct RedGreenStorage
{
  CellStorage<Out> Cells{ nullptr, nullptr, nullptr };
  unsigned char* Levels = nullptr;   ///< of the leaf that a cell is, or is a green part of
  unsigned char* Kinds = nullptr;    ///< RefinementKind
  vtkIdType* GreenParents = nullptr; ///< index for GetGreenLeaf(), -1
  vtkIdType* InputCells = nullptr;   ///< of which each cell is a part
};

/// A leaf that the output has in parts. Another run starts from these: RedGreen::AddMidpoint.
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
 * Plans the output of a state, which must not change while the plan is used. Cells stay in input
 * order, children stand together in the place of their parent, in the order of Simplices.h; the
 * vertices of green children stand where those of their leaf stood, so that orientation is kept.
 * Cells that nothing happened to are copied in threads.
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
  /// A leaf of a tree where something happened, or a red cell whose children are not stored.
  struct Leaf
  {
    Id Node;
    vtkIdType FirstCell;
    vtkIdType FirstEntry;
    vtkIdType Green; ///< its number among the green ones, -1
  };
  /// Such a tree: sizes while they are counted, then where its parts start.
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
  Buffer<vtkIdType> Greens; ///< among the leaves
};

/// Placement `Linear`: vertices of the input stay where they are, those after them have rows of
/// dyadic weights, which are exact: up to four, or seven where the input has midpoints itself.
template <typename Id>
struct MidpointRows
{
  SparseRows<Id> Added;

  vtkIdType GetNumberOfRows() const
  {
    return this->Added.NumberOfColumns + this->Added.GetNumberOfRows();
  }
  /// As in SparseRows.
  template <typename T>
  void Apply(const T* in, T* out, int components) const
  {
    const vtkIdType given = this->Added.NumberOfColumns * components;
    ForRanges(
      given, [=](vtkIdType begin, vtkIdType end) { std::copy(in + begin, in + end, out + begin); });
    this->Added.Apply(in, out + given, components);
  }
};

template <typename Id>
MidpointRows<Id> MakeMidpointRows(const RedGreen<Id>& state);

}

#endif
