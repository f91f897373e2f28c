// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenActivation.cxx
 * Which cells of the input are stored, and when.
 */
#include "Core/Solids/RedGreen/RedGreen.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/RedGreen/RedGreenTables.h"

namespace subdivision
{

using redgreen::NumberOfEdges;

/// The vertices of an input cell in their final order.
template <typename Id>
void RedGreen<Id>::ReadInput(Id cell, vtkIdType* vertices) const
{
  const vtkIdType* own = this->Input.Connectivity + this->Places[cell];
  const int dimension = this->Input.Dimensions[cell];
  std::copy(own, own + dimension + 1, vertices);
  if (dimension == 3 && this->OrderTet && this->Input.GetLevel(cell) == 0)
  {
    this->OrderTet(vertices);
  }
}

/// Makes the nodes of input cells that have none.
template <typename Id>
void RedGreen<Id>::StoreInputs(const std::vector<Id>& cells)
{
  const Id first = static_cast<Id>(this->Nodes.size());
  std::vector<Id> fresh;
  fresh.reserve(cells.size());
  Turns turns;
  for (Id cell : cells)
  {
    turns.Next();
    if (this->Roots[cell] < 0)
    {
      this->Roots.Set(cell, first + static_cast<Id>(fresh.size()));
      fresh.push_back(cell);
    }
  }
  Node* nodes = this->Nodes.Extend(static_cast<vtkIdType>(fresh.size()));
  ForEach(static_cast<vtkIdType>(fresh.size()),
    [&](vtkIdType i)
    {
      const Id cell = fresh[i];
      Node node{};
      node.Input = cell;
      node.Parent = -1;
      node.FirstChild = -1;
      node.Dimension = this->Input.Dimensions[cell];
      node.Level = static_cast<unsigned char>(this->Input.GetLevel(cell));
      vtkIdType vertices[4];
      this->ReadInput(cell, vertices);
      for (int k = 0; k <= node.Dimension; ++k)
      {
        node.Vertices[k] = static_cast<Id>(vertices[k]);
      }
      std::fill(node.Edges, node.Edges + 6, Id(-1));
      nodes[i] = node;
    });
}

template <typename Id>
void RedGreen<Id>::Expect(const std::vector<Id>& cells)
{
  // A mesh of tetrahedra has little more than one edge for each cell.
  const vtkIdType edges = this->Edges.size() + static_cast<vtkIdType>(cells.size()) * 3 / 2;
  this->Nodes.Reserve(this->Nodes.size() + 2 * static_cast<vtkIdType>(cells.size()));
  this->Edges.Reserve(edges);
  this->EdgesByEnds.Reserve(edges);
  this->StoreInputs(cells);
}

/// The node of an input cell, made if need be.
template <typename Id>
Id RedGreen<Id>::Activate(Id cell)
{
  if (this->Roots[cell] < 0)
  {
    this->StoreInputs({ cell });
  }
  const Id index = this->Roots[cell];
  this->LookUpEdges(index);
  return index;
}

/// Looks up the edges of an input cell that may be split: edges between flagged vertices.
template <typename Id>
void RedGreen<Id>::LookUpEdges(Id index)
{
  const int dimension = this->Nodes[index].Dimension;
  int flagged = 0;
  bool flags[4];
  for (int i = 0; i <= dimension; ++i)
  {
    flags[i] = this->Flags[this->Nodes[index].Vertices[i]] != 0;
    flagged += flags[i];
  }
  if (flagged < 2 || flagged == this->Nodes[index].Flagged)
  {
    return;
  }
  this->Nodes[index].Flagged = static_cast<unsigned char>(flagged);
  for (int k = 0; k < NumberOfEdges[dimension]; ++k)
  {
    const int* ends = redgreen::EndsOf(dimension, k);
    if (flags[ends[0]] && flags[ends[1]])
    {
      this->GetEdge(index, k);
    }
  }
  this->Settle(index);
}

template <typename Id>
Id RedGreen<Id>::GetEdge(Id index, int k)
{
  Node& node = this->Nodes[index];
  if (node.Edges[k] < 0)
  {
    const int* ends = redgreen::EndsOf(node.Dimension, k);
    node.Edges[k] = this->FindOrAddEdge(node.Vertices[ends[0]], node.Vertices[ends[1]]);
    this->AddUse(index, k);
  }
  return node.Edges[k];
}

template <typename Id>
void RedGreen<Id>::FlagEnds(const Edge& edge)
{
  if (std::max(edge.Ends[0], edge.Ends[1]) >= this->InputVertices)
  {
    return; // no cell of the input has it
  }
  for (Id end : edge.Ends)
  {
    if (!this->Flags[end])
    {
      this->Flags[end] = 1;
      this->NewFlags.push_back(end);
    }
  }
}

/// Stores the cells of the input that may have a split edge: two of their vertices are flagged.
template <typename Id>
void RedGreen<Id>::ActivateNearFlags()
{
  constexpr vtkIdType scansWorthIncidence = 4;
  const bool scans = this->ScannedCells < scansWorthIncidence * this->Input.NumberOfSimplices;
  const std::vector<Id> cells = scans ? this->ScanCells() : this->FollowIncidence();
  this->NewFlags.clear();
  this->StoreInputs(cells);
  ForEachInTurn(
    static_cast<vtkIdType>(cells.size()), [&](vtkIdType i) { this->Activate(cells[i]); });
}

template <typename Id>
int RedGreen<Id>::CountFlagged(const vtkIdType* vertices, int corners) const
{
  int flagged = 0;
  for (int i = 0; i < corners; ++i)
  {
    flagged += this->Flags[vertices[i]];
  }
  return flagged;
}

/// Whether an input cell with so many flagged vertices has edges that are to be looked up.
template <typename Id>
bool RedGreen<Id>::IsNearFlags(vtkIdType cell, int flagged) const
{
  if (flagged < 2 || this->GetScope(cell) == CellScope::Ignored)
  {
    return false;
  }
  const Id root = this->Roots[cell];
  return root < 0 || this->Nodes[root].Flagged < flagged;
}

namespace
{

/// Tells whether a list may have ids in a range. It counts ids in buckets of 64.
template <typename Id>
class RangeCounts
{
public:
  RangeCounts(const std::vector<Id>& ids, Id size)
    : Counts(size / BucketSize + vtkIdType(2), Id(0))
  {
    for (Id id : ids)
    {
      ++this->Counts[id / BucketSize];
    }
    CountsToOffsets(this->Counts);
  }
  /// False only if there is none from `least` to `most`.
  bool HasAny(Id least, Id most) const
  {
    return this->Counts[least / BucketSize] < this->Counts[most / BucketSize + vtkIdType(1)];
  }

private:
  static constexpr Id BucketSize = 64;
  Buffer<Id> Counts;
};

}

/// The input cells with newly flagged vertices to be stored. Scans the blocks of cells whose range
/// of vertices has newly flagged ones.
template <typename Id>
std::vector<Id> RedGreen<Id>::ScanCells()
{
  constexpr vtkIdType blockSize = 4096;
  const vtkIdType size = this->Input.NumberOfSimplices;
  const RangeCounts<Id> news(this->NewFlags, this->InputVertices);
  const bool isFirst = this->BlockRanges.empty();
  if (isFirst)
  {
    this->BlockRanges = Buffer<Range>((size + blockSize - 1) / blockSize);
  }
  std::vector<vtkIdType> blocks;
  for (vtkIdType block = 0; block < this->BlockRanges.size(); ++block)
  {
    const Range& range = this->BlockRanges[block];
    if (isFirst || news.HasAny(range.Least, range.Most))
    {
      blocks.push_back(block);
    }
  }
  std::vector<std::vector<Id>> found(blocks.size());
  const auto scan = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const vtkIdType first = blocks[i] * blockSize;
      const vtkIdType last = std::min(size, first + blockSize);
      const vtkIdType* vertices = this->Input.Connectivity + this->Places[first];
      Range& range = this->BlockRanges[blocks[i]];
      if (isFirst)
      {
        range = FindRange(vertices, this->Places[last] - this->Places[first]);
        if (!news.HasAny(range.Least, range.Most))
        {
          continue;
        }
      }
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        const int corners = this->Input.Dimensions[cell] + 1;
        if (this->IsNearFlags(cell, this->CountFlagged(vertices, corners)))
        {
          found[i].push_back(static_cast<Id>(cell));
        }
        vertices += corners;
      }
    }
  };
  ForRangesOfBlocks(static_cast<vtkIdType>(blocks.size()), scan);
  this->ScannedCells += blockSize * static_cast<vtkIdType>(blocks.size());
  std::vector<Id> cells;
  for (const auto& block : found)
  {
    cells.insert(cells.end(), block.begin(), block.end());
  }
  return cells;
}

template <typename Id>
typename RedGreen<Id>::Range RedGreen<Id>::FindRange(const vtkIdType* vertices, vtkIdType size)
{
  Id least = static_cast<Id>(vertices[0]);
  Id most = least;
  for (vtkIdType i = 1; i < size; ++i)
  {
    least = std::min(least, static_cast<Id>(vertices[i]));
    most = std::max(most, static_cast<Id>(vertices[i]));
  }
  return { least, most };
}

template <typename Id>
std::vector<Id> RedGreen<Id>::FollowIncidence()
{
  if (this->Incidence.Offsets.empty())
  {
    this->BuildIncidence();
  }
  std::vector<Id> cells;
  for (Id vertex : InTurn(this->NewFlags))
  {
    for (Id cell : this->Incidence[vertex])
    {
      const vtkIdType* vertices = this->Input.Connectivity + this->Places[cell];
      if (this->IsNearFlags(cell, this->CountFlagged(vertices, this->Input.Dimensions[cell] + 1)))
      {
        cells.push_back(cell);
      }
    }
  }
  SortDistinct(cells);
  return cells;
}

template <typename Id>
void RedGreen<Id>::BuildIncidence()
{
  const vtkIdType size = this->Input.NumberOfSimplices;
  const vtkIdType entries = this->Places[size];
  this->Incidence.Offsets = Buffer<Id>(this->InputVertices + vtkIdType(1), Id(0));
  for (const vtkIdType i : InTurn(entries))
  {
    ++this->Incidence.Offsets[this->Input.Connectivity[i]];
  }
  CountsToOffsets(this->Incidence.Offsets);
  this->Incidence.Items = Buffer<Id>(entries);
  Buffer<Id> next(this->InputVertices);
  std::copy(this->Incidence.Offsets.begin(), this->Incidence.Offsets.end() - 1, next.begin());
  const vtkIdType* vertex = this->Input.Connectivity;
  ForEachInTurn(size,
    [&](vtkIdType cell)
    {
      for (int i = 0; i <= this->Input.Dimensions[cell]; ++i)
      {
        this->Incidence.Items[next[*vertex++]++] = static_cast<Id>(cell);
      }
    });
}

SUBDIVISION_COMPILE(class RedGreen);

}
