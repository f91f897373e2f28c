// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/RedGreen/RedGreenOutput.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ForBlocks.h"
#include "Core/Solids/RedGreen/RedGreenTables.h"

#include "vtkCellType.h"

#include <utility>

namespace subdivision
{
namespace
{

constexpr unsigned char TypeOfDimension[4] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };

RefinementKind KindOfUnsplit(int level)
{
  return level > 0 ? RefinementKind::Red : RefinementKind::Untouched;
}

/// Copies the unsplit input cells `cell` to `end` - 1. Their connectivity starts at `from`; cell
/// `to` of the output is the first, with its connectivity at `toEntry`.
template <typename Out>
void CopyRun(const SimplexView& input, vtkIdType cell, vtkIdType end, vtkIdType from, vtkIdType to,
  vtkIdType toEntry, const RedGreenStorage<Out>& out)
{
  vtkIdType entry = toEntry;
  for (vtkIdType i = cell; i < end; ++i)
  {
    const vtkIdType target = to + (i - cell);
    const int dimension = input.Dimensions[i];
    out.Cells.Types[target] = TypeOfDimension[dimension];
    out.Cells.Offsets[target] = static_cast<Out>(entry);
    entry += dimension + 1;
  }
  for (vtkIdType i = 0; i < entry - toEntry; ++i)
  {
    out.Cells.Connectivity[toEntry + i] = static_cast<Out>(input.Connectivity[from + i]);
  }
  const vtkIdType size = end - cell;
  for (vtkIdType i = 0; out.Levels && i < size; ++i)
  {
    out.Levels[to + i] = static_cast<unsigned char>(input.GetLevel(cell + i));
  }
  for (vtkIdType i = 0; out.Kinds && i < size; ++i)
  {
    out.Kinds[to + i] = static_cast<unsigned char>(KindOfUnsplit(input.GetLevel(cell + i)));
  }
  if (out.GreenParents)
  {
    std::fill(out.GreenParents + to, out.GreenParents + to + size, vtkIdType(-1));
  }
  for (vtkIdType i = 0; out.InputCells && i < size; ++i)
  {
    out.InputCells[to + i] = cell + i;
  }
}

}

template <typename Id>
RedGreenOutput<Id>::RedGreenOutput(const RedGreen<Id>& state)
  : State(state)
{
  this->FindTrees();
  this->PlaceTrees();
  ForEach(this->Trees.size(),
    [&](vtkIdType i)
    {
      Tree next = this->Trees[i];
      this->PlaceLeaves(next.Root, next);
    });
}

/// Finds the trees with split edges, in input order, and counts their cells.
template <typename Id>
void RedGreenOutput<Id>::FindTrees()
{
  const auto& roots = this->State.Roots;
  std::vector<std::vector<Id>> found(roots.GetNumberOfPages());
  Buffer<vtkIdType> starts(roots.GetNumberOfPages() + 1);
  const auto find = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end; ++block)
    {
      for (Id root : roots.GetPage(block))
      {
        if (root >= 0 && this->State.Nodes[root].Pattern != 0)
        {
          found[block].push_back(root);
        }
      }
      starts[block] = static_cast<vtkIdType>(found[block].size());
    }
  };
  const auto count = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end; ++block)
    {
      Tree* tree = this->Trees.data() + starts[block];
      for (Id root : found[block])
      {
        *tree = { root, this->State.Nodes[root].Input, 0, 0, 0, 0 };
        this->CountLeaves(root, *tree++);
      }
    }
  };
  ForRangesOfBlocks(static_cast<vtkIdType>(found.size()), find);
  CountsToOffsets(starts);
  this->Trees = Buffer<Tree>(starts[starts.size() - 1]);
  ForRangesOfBlocks(static_cast<vtkIdType>(found.size()), count);
}

template <typename Id>
void RedGreenOutput<Id>::CountLeaves(Id index, Tree& tree) const
{
  const auto& node = this->State.Nodes[index];
  const auto& parts = redgreen::PartsOf[node.Dimension][node.Pattern];
  if (node.FirstChild >= 0)
  {
    for (int child = 0; child < parts.Count; ++child)
    {
      this->CountLeaves(node.FirstChild + child, tree);
    }
    return;
  }
  tree.Cells += parts.Count;
  tree.Entries += parts.Count * (node.Dimension + 1);
  ++tree.Leaves;
  tree.Greens += parts.Kind >= RefinementKind::GreenI ? 1 : 0;
}

/// Turns the counts of trees into positions. Between trees there are unsplit input cells.
template <typename Id>
void RedGreenOutput<Id>::PlaceTrees()
{
  vtkIdType cell = 0; // input cells before this one have a position
  vtkIdType entry = 0;
  vtkIdType leaves = 0;
  vtkIdType greens = 0;
  for (Tree& tree : this->Trees)
  {
    const vtkIdType place = this->State.Places[tree.Input];
    this->Counts.Cells += tree.Input - cell;
    this->Counts.Entries += place - entry;
    cell = tree.Input + vtkIdType(1);
    entry = place + this->State.Input.Dimensions[tree.Input] + 1;
    const vtkIdType cells = std::exchange(tree.Cells, this->Counts.Cells);
    const vtkIdType entries = std::exchange(tree.Entries, this->Counts.Entries);
    this->Counts.Cells += cells;
    this->Counts.Entries += entries;
    leaves += std::exchange(tree.Leaves, leaves);
    greens += std::exchange(tree.Greens, greens);
  }
  this->Counts.Cells += this->State.Input.NumberOfSimplices - cell;
  this->Counts.Entries += this->State.Places[this->State.Input.NumberOfSimplices] - entry;
  this->Leaves = Buffer<Leaf>(leaves);
  this->Greens = Buffer<vtkIdType>(greens);
}

template <typename Id>
void RedGreenOutput<Id>::PlaceLeaves(Id index, Tree& next)
{
  const auto& node = this->State.Nodes[index];
  const auto& parts = redgreen::PartsOf[node.Dimension][node.Pattern];
  if (node.FirstChild >= 0)
  {
    for (int child = 0; child < parts.Count; ++child)
    {
      this->PlaceLeaves(node.FirstChild + child, next);
    }
    return;
  }
  const bool green = parts.Kind >= RefinementKind::GreenI;
  if (green)
  {
    this->Greens[next.Greens] = next.Leaves;
  }
  this->Leaves[next.Leaves++] = { index, next.Cells, next.Entries,
    green ? next.Greens++ : vtkIdType(-1) };
  next.Cells += parts.Count;
  next.Entries += parts.Count * (node.Dimension + 1);
}

template <typename Id>
GreenLeaf<Id> RedGreenOutput<Id>::GetGreenLeaf(vtkIdType i) const
{
  const Leaf& place = this->Leaves[this->Greens[i]];
  const auto& node = this->State.Nodes[place.Node];
  GreenLeaf<Id> leaf;
  leaf.Input = node.Input;
  leaf.Dimension = node.Dimension;
  leaf.Level = node.Level;
  leaf.FirstCell = place.FirstCell;
  leaf.NumberOfCells = redgreen::PartsOf[node.Dimension][node.Pattern].Count;
  Id lattice[10];
  this->State.GetLattice(node, lattice);
  std::copy(lattice, lattice + node.Dimension + 1, leaf.Vertices.begin());
  std::copy(lattice + node.Dimension + 1,
    lattice + node.Dimension + 1 + redgreen::NumberOfEdges[node.Dimension], leaf.Midpoints.begin());
  return leaf;
}

template <typename Id>
template <typename Out>
void RedGreenOutput<Id>::Write(const RedGreenStorage<Out>& out) const
{
  const SimplexView& input = this->State.Input;
  ForEach(this->Leaves.size(), [&](vtkIdType i) { this->WriteLeaf(this->Leaves[i], out); });
  constexpr vtkIdType blockSize = 4096;
  const auto copyBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    begin *= blockSize;
    end = std::min(input.NumberOfSimplices, end * blockSize);
    // The first tree from `begin` on.
    auto tree = std::lower_bound(this->Trees.begin(), this->Trees.end(), begin,
      [](const Tree& t, vtkIdType cell) { return t.Input < cell; });
    while (begin < end)
    {
      const bool last = tree == this->Trees.end();
      const vtkIdType stop = last ? end : std::min<vtkIdType>(end, tree->Input);
      if (begin < stop)
      {
        // Positions are counted back from the next tree, or from the end of the output.
        const vtkIdType from = this->State.Places[begin];
        const vtkIdType next = last ? input.NumberOfSimplices : vtkIdType(tree->Input);
        const CellCounts place = last ? this->Counts : CellCounts{ tree->Cells, tree->Entries };
        CopyRun(input, begin, stop, from, place.Cells - (next - begin),
          place.Entries - (this->State.Places[next] - from), out);
      }
      begin = stop + 1;
      tree += last ? 0 : 1;
    }
  };
  const vtkIdType blocks = (input.NumberOfSimplices + blockSize - 1) / blockSize;
  ForRangesOfBlocks(blocks, copyBlocks);
  out.Cells.Offsets[this->Counts.Cells] = static_cast<Out>(this->Counts.Entries);
}

/// The cells in the place of a leaf, or of a red cell whose children are not stored.
template <typename Id>
template <typename Out>
void RedGreenOutput<Id>::WriteLeaf(const Leaf& leaf, const RedGreenStorage<Out>& out) const
{
  const auto& node = this->State.Nodes[leaf.Node];
  const auto& parts = redgreen::PartsOf[node.Dimension][node.Pattern];
  const bool red = parts.Kind == RefinementKind::Red;
  const int level = node.Level + (red ? 1 : 0);
  const RefinementKind kind = node.Pattern == 0 ? KindOfUnsplit(level) : parts.Kind;
  Id lattice[10];
  this->State.GetLattice(node, lattice);
  vtkIdType entry = leaf.FirstEntry;
  for (int part = 0; part < parts.Count; ++part)
  {
    const vtkIdType cell = leaf.FirstCell + part;
    out.Cells.Types[cell] = TypeOfDimension[node.Dimension];
    out.Cells.Offsets[cell] = static_cast<Out>(entry);
    for (int i = 0; i <= node.Dimension; ++i)
    {
      out.Cells.Connectivity[entry++] = static_cast<Out>(lattice[parts.Vertices[part][i]]);
    }
    if (out.Levels)
    {
      out.Levels[cell] = static_cast<unsigned char>(level);
    }
    if (out.Kinds)
    {
      out.Kinds[cell] = static_cast<unsigned char>(kind);
    }
    if (out.GreenParents)
    {
      out.GreenParents[cell] = leaf.Green;
    }
    if (out.InputCells)
    {
      out.InputCells[cell] = node.Input;
    }
  }
}

namespace
{

/// Puts the last entries, from `first` on, into the order of their columns, so that the sum does
/// not depend on the order in which edges were split.
template <typename Id>
void SortRow(GrowingBuffer<Id>& columns, GrowingBuffer<double>& weights, vtkIdType first)
{
  for (vtkIdType i = first + 1; i < columns.size(); ++i)
  {
    for (vtkIdType k = i; k > first && columns[k] < columns[k - 1]; --k)
    {
      std::swap(columns[k], columns[k - 1]);
      std::swap(weights[k], weights[k - 1]);
    }
  }
}

}

template <typename Id>
void MidpointRows<Id>::ForEachBlock(const User& use) const
{
  const vtkIdType given = this->Added.NumberOfColumns;
  ForRanges(
    given, [&](vtkIdType begin, vtkIdType end) { use(CopiedRows{ begin, end - begin, begin }); });
  ForBlocksInThreads(this->Added.GetNumberOfRows(),
    [&](vtkIdType begin, vtkIdType end)
    {
      WeightedRows<Id> rows = this->Added.GetRows(begin, end);
      rows.FirstRow += given;
      use(rows);
    });
}

template <typename Id>
MidpointRows<Id> MakeRowsOfMidpoints(
  Id inputs, const std::vector<std::array<Id, 2>>& ends, const std::vector<WeightedVertices>& means)
{
  const auto midpoints = static_cast<vtkIdType>(ends.size());
  const vtkIdType size = midpoints + static_cast<vtkIdType>(means.size());
  MidpointRows<Id> result;
  SparseRows<Id>& added = result.Added;
  added.NumberOfColumns = inputs;
  added.Offsets = Buffer<Id>(size + 1);
  added.Offsets[0] = 0;
  // Each row is made of the rows of its ends, which are earlier. Sums are exact.
  GrowingBuffer<Id> columns;
  GrowingBuffer<double> weights;
  for (const vtkIdType row : InTurn(size))
  {
    const vtkIdType first = columns.size();
    const auto add = [&](Id column, double weight)
    {
      vtkIdType k = first;
      while (k < columns.size() && columns[k] != column)
      {
        ++k;
      }
      if (k == columns.size())
      {
        columns.push_back(column);
        weights.push_back(0.);
      }
      weights[k] += weight;
    };
    const auto addRow = [&](vtkIdType end, double factor)
    {
      if (end < inputs)
      {
        add(static_cast<Id>(end), factor);
        return;
      }
      const vtkIdType last = added.Offsets[end - inputs + 1];
      for (vtkIdType k = added.Offsets[end - inputs]; k < last; ++k)
      {
        add(columns[k], factor * weights[k]);
      }
    };
    if (row < midpoints)
    {
      addRow(ends[row][0], 0.5);
      addRow(ends[row][1], 0.5);
    }
    else
    {
      double all = 0.;
      for (const auto& [vertex, weight] : means[row - midpoints])
      {
        vertex >= 0 ? addRow(vertex, weight) : void();
        all += weight;
      }
      for (vtkIdType k = first; k < weights.size(); ++k)
      {
        weights[k] /= all;
      }
    }
    SortRow(columns, weights, first);
    added.Offsets[row + 1] = static_cast<Id>(columns.size());
  }
  added.Columns = columns.Copy();
  added.Weights = weights.Copy();
  return result;
}

SUBDIVISION_COMPILE(class RedGreenOutput);
SUBDIVISION_COMPILE(struct MidpointRows);
SUBDIVISION_COMPILE_FUNCTION(MakeRowsOfMidpoints);
#define SUBDIVISION_RED_GREEN_OUTPUT(Id)                                                           \
  template void RedGreenOutput<Id>::Write(const RedGreenStorage<int>&) const;                      \
  template void RedGreenOutput<Id>::Write(const RedGreenStorage<long long>&) const
SUBDIVISION_RED_GREEN_OUTPUT(int);
SUBDIVISION_RED_GREEN_OUTPUT(long long);

}
