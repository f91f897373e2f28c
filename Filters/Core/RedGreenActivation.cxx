// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenActivation.cxx
 * Which cells of the input are stored, and when.
 */
#include "RedGreen.h"

#include "RedGreenTables.h"

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

/// The node of an input cell, made if need be.
template <typename Id>
Id RedGreen<Id>::Activate(Id cell)
{
  if (this->Roots[cell] >= 0)
  {
    this->LookUpEdges(this->Roots[cell]);
    return this->Roots[cell];
  }
  const Id index = static_cast<Id>(this->Nodes.size());
  Node node{};
  node.Input = cell;
  node.Parent = -1;
  node.FirstChild = -1;
  node.Dimension = this->Input.Dimensions[cell];
  node.Level = static_cast<unsigned char>(this->Input.GetLevel(cell));
  vtkIdType vertices[4];
  this->ReadInput(cell, vertices);
  for (int i = 0; i <= node.Dimension; ++i)
  {
    node.Vertices[i] = static_cast<Id>(vertices[i]);
  }
  std::fill(node.Edges, node.Edges + 6, Id(-1));
  this->Roots[cell] = index;
  this->Nodes.push_back(node);
  this->LookUpEdges(index);
  return index;
}

/// Looks up the edges of an input cell that may be split: those between flagged vertices.
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
  constexpr int scansWorthIncidence = 4;
  const std::vector<Id> cells =
    this->Scans++ < scansWorthIncidence ? this->ScanCells() : this->FollowIncidence();
  this->NewFlags.clear();
  this->Nodes.Reserve(this->Nodes.size() + static_cast<vtkIdType>(cells.size()));
  for (Id cell : cells)
  {
    this->Activate(cell);
  }
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
  return flagged >= 2 &&
    (this->Roots[cell] < 0 || this->Nodes[this->Roots[cell]].Flagged < flagged);
}

template <typename Id>
std::vector<Id> RedGreen<Id>::ScanCells() const
{
  constexpr vtkIdType blockSize = 256 * SimplexPlaces::BlockSize;
  const vtkIdType size = this->Input.NumberOfSimplices;
  std::vector<std::vector<Id>> found((size + blockSize - 1) / blockSize);
  const auto scan = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end; ++block)
    {
      const vtkIdType last = std::min(size, (block + 1) * blockSize);
      const vtkIdType* vertices = this->Input.Connectivity + this->Places[block * blockSize];
      for (vtkIdType cell = block * blockSize; cell < last; ++cell)
      {
        const int corners = this->Input.Dimensions[cell] + 1;
        if (this->IsNearFlags(cell, this->CountFlagged(vertices, corners)))
        {
          found[block].push_back(static_cast<Id>(cell));
        }
        vertices += corners;
      }
    }
  };
  ForBlocks(static_cast<vtkIdType>(found.size()), scan);
  std::vector<Id> cells;
  for (const auto& block : found)
  {
    cells.insert(cells.end(), block.begin(), block.end());
  }
  return cells;
}

template <typename Id>
std::vector<Id> RedGreen<Id>::FollowIncidence()
{
  if (this->Incidence.Offsets.empty())
  {
    this->BuildIncidence();
  }
  std::vector<Id> cells;
  for (Id vertex : this->NewFlags)
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
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

template <typename Id>
void RedGreen<Id>::BuildIncidence()
{
  const vtkIdType size = this->Input.NumberOfSimplices;
  const vtkIdType entries = this->Places[size];
  this->Incidence.Offsets = Buffer<Id>(this->InputVertices + vtkIdType(1), Id(0));
  for (vtkIdType i = 0; i < entries; ++i)
  {
    ++this->Incidence.Offsets[this->Input.Connectivity[i]];
  }
  CountsToOffsets(this->Incidence.Offsets);
  this->Incidence.Items = Buffer<Id>(entries);
  Buffer<Id> next(this->InputVertices);
  std::copy(this->Incidence.Offsets.begin(), this->Incidence.Offsets.end() - 1, next.begin());
  const vtkIdType* vertex = this->Input.Connectivity;
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    for (int i = 0; i <= this->Input.Dimensions[cell]; ++i)
    {
      this->Incidence.Items[next[*vertex++]++] = static_cast<Id>(cell);
    }
  }
}

template class RedGreen<int>;
template class RedGreen<long long>;

}
