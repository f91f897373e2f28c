// SPDX-License-Identifier: BSD-3-Clause
#include "RedGreenOutput.h"

#include "RedGreenTables.h"

#include "vtkCellType.h"

namespace subdivision
{
namespace
{

constexpr unsigned char TypeOfDimension[4] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };

RefinementKind KindOfUnsplit(int level)
{
  return level > 0 ? RefinementKind::Red : RefinementKind::Untouched;
}

/// Input cells that stay as they are, from `cell` to `end`.
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
  std::vector<Id> roots;
  for (std::size_t i = 0; i < state.Nodes.size(); ++i)
  {
    if (state.Nodes[i].Parent < 0 && state.Nodes[i].Pattern != 0)
    {
      roots.push_back(static_cast<Id>(i));
    }
  }
  std::sort(roots.begin(), roots.end(),
    [&](Id a, Id b) { return state.Nodes[a].Input < state.Nodes[b].Input; });
  vtkIdType cell = 0; // of the input, up to which all is planned
  vtkIdType entry = 0;
  this->Trees.reserve(roots.size());
  this->Leaves.reserve(roots.size());
  for (Id root : roots)
  {
    const auto& node = state.Nodes[root];
    const vtkIdType place = state.Places[node.Input];
    this->Counts.Cells += node.Input - cell;
    this->Counts.Entries += place - entry;
    cell = node.Input + vtkIdType(1);
    entry = place + node.Dimension + 1;
    this->Collect(root);
    this->Trees.push_back({ node.Input, this->Counts.Cells, this->Counts.Entries });
  }
  this->Counts.Cells += state.Input.NumberOfSimplices - cell;
  this->Counts.Entries += state.Places[state.Input.NumberOfSimplices] - entry;
}

/// Plans the leaves of a tree.
template <typename Id>
void RedGreenOutput<Id>::Collect(Id index)
{
  const auto& node = this->State.Nodes[index];
  const auto& parts = redgreen::PartsOf[node.Dimension][node.Pattern];
  if (node.FirstChild >= 0)
  {
    for (int child = 0; child < parts.Count; ++child)
    {
      this->Collect(node.FirstChild + child);
    }
    return;
  }
  const bool green = parts.Kind >= RefinementKind::GreenI;
  this->Leaves.push_back({ index, this->Counts.Cells, this->Counts.Entries,
    green ? static_cast<vtkIdType>(this->GreenLeaves.size()) : -1 });
  if (green)
  {
    GreenLeaf<Id> leaf;
    leaf.Input = node.Input;
    leaf.Dimension = node.Dimension;
    leaf.Level = node.Level;
    leaf.FirstCell = this->Counts.Cells;
    leaf.NumberOfCells = parts.Count;
    std::copy(node.Vertices, node.Vertices + node.Dimension + 1, leaf.Vertices.begin());
    for (int k = 0; k < redgreen::NumberOfEdges[node.Dimension]; ++k)
    {
      leaf.Midpoints[k] = this->State.Edges[node.Edges[k]].Midpoint;
    }
    this->GreenLeaves.push_back(leaf);
  }
  this->Counts.Cells += parts.Count;
  this->Counts.Entries += parts.Count * (node.Dimension + 1);
}

template <typename Id>
template <typename Out>
void RedGreenOutput<Id>::Write(const RedGreenStorage<Out>& out) const
{
  const SimplexView& input = this->State.Input;
  ForEach(static_cast<vtkIdType>(this->Leaves.size()),
    [&](vtkIdType i) { this->WriteLeaf(this->Leaves[i], out); });
  constexpr vtkIdType blockSize = 64 * SimplexPlaces::BlockSize;
  auto copyBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    begin *= blockSize;
    end = std::min(input.NumberOfSimplices, end * blockSize);
    // The trees in this stretch, and the one before, which says where its cells go.
    auto tree = std::lower_bound(this->Trees.begin(), this->Trees.end(), begin,
      [](const Tree& t, vtkIdType cell) { return t.Input < cell; });
    while (begin < end)
    {
      const vtkIdType stop =
        tree == this->Trees.end() ? end : std::min<vtkIdType>(end, tree->Input);
      if (begin < stop)
      {
        const vtkIdType from = this->State.Places[begin];
        vtkIdType to = begin;
        vtkIdType toEntry = from;
        if (tree != this->Trees.begin())
        {
          const Tree& before = *(tree - 1);
          to = before.EndCell + (begin - before.Input - 1);
          toEntry = before.EndEntry + (from - this->State.Places[before.Input + vtkIdType(1)]);
        }
        CopyRun(input, begin, stop, from, to, toEntry, out);
      }
      begin = stop + 1;
      if (tree != this->Trees.end())
      {
        ++tree;
      }
    }
  };
  const vtkIdType blocks = (input.NumberOfSimplices + blockSize - 1) / blockSize;
  if (blocks > 1)
  {
    vtkSMPTools::For(0, blocks, 1, copyBlocks);
  }
  else
  {
    copyBlocks(0, blocks);
  }
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

/// A row of at most four entries.
template <typename Id>
struct ShortRow
{
  int Size = 0;
  Id Columns[4] = {};
  double Weights[4] = {};

  void Add(Id column, double weight)
  {
    int i = 0;
    while (i < this->Size && this->Columns[i] != column)
    {
      ++i;
    }
    if (i == this->Size)
    {
      this->Columns[this->Size++] = column;
      this->Weights[i] = 0.;
    }
    this->Weights[i] += weight;
  }
};

}

template <typename Id>
SparseRows<Id> MakeMidpointRows(const RedGreen<Id>& state)
{
  const vtkIdType inputs = state.GetNumberOfInputVertices();
  const vtkIdType size = state.GetNumberOfVertices();
  Buffer<ShortRow<Id>> rows(size - inputs);
  SparseRows<Id> result;
  result.NumberOfColumns = inputs;
  result.Offsets = Buffer<Id>(size + 1);
  for (vtkIdType v = inputs; v < size; ++v)
  {
    ShortRow<Id> row;
    for (Id end : state.GetEnds(static_cast<Id>(v)))
    {
      if (end < inputs)
      {
        row.Add(end, 0.5);
        continue;
      }
      const ShortRow<Id>& other = rows[end - inputs];
      for (int i = 0; i < other.Size; ++i)
      {
        row.Add(other.Columns[i], 0.5 * other.Weights[i]);
      }
    }
    rows[v - inputs] = row;
  }
  ForEach(size, [&](vtkIdType v) { result.Offsets[v] = v < inputs ? 1 : rows[v - inputs].Size; });
  CountsToOffsets(result.Offsets);
  result.Columns = Buffer<Id>(result.Offsets[size]);
  result.Weights = Buffer<double>(result.Offsets[size]);
  ForEach(size,
    [&](vtkIdType v)
    {
      const Id first = result.Offsets[v];
      if (v < inputs)
      {
        result.Columns[first] = static_cast<Id>(v);
        result.Weights[first] = 1.;
        return;
      }
      const ShortRow<Id>& row = rows[v - inputs];
      std::copy(row.Columns, row.Columns + row.Size, result.Columns.data() + first);
      std::copy(row.Weights, row.Weights + row.Size, result.Weights.data() + first);
    });
  return result;
}

#define SUBDIVISION_RED_GREEN_OUTPUT(Id)                                                           \
  template class RedGreenOutput<Id>;                                                               \
  template void RedGreenOutput<Id>::Write(const RedGreenStorage<int>&) const;                      \
  template void RedGreenOutput<Id>::Write(const RedGreenStorage<long long>&) const;                \
  template SparseRows<Id> MakeMidpointRows(const RedGreen<Id>&)
SUBDIVISION_RED_GREEN_OUTPUT(int);
SUBDIVISION_RED_GREEN_OUTPUT(long long);

}
