// SPDX-License-Identifier: BSD-3-Clause
#include "RedGreen.h"

#include "RedGreenTables.h"

namespace subdivision
{

using redgreen::Full;
using redgreen::NumberOfEdges;
using redgreen::PartsOf;

template <typename Id>
std::vector<RedGreenOutputCell<Id>> RedGreen<Id>::GetChangedCells() const
{
  std::vector<RedGreenOutputCell<Id>> cells;
  std::size_t most = 0;
  for (Id index : this->LastChanges)
  {
    const Node& node = this->Nodes[index];
    most += PartsOf[node.Dimension][node.Pattern].Count;
  }
  cells.reserve(most);
  AdviseHugePages(cells.data(), cells.capacity() * sizeof(RedGreenOutputCell<Id>));
  for (Id index : this->LastChanges)
  {
    const Node& node = this->Nodes[index];
    const bool red = this->IsNodeRed(node);
    Id lattice[10];
    this->GetLattice(node, lattice);
    const auto& parts = PartsOf[node.Dimension][node.Pattern];
    RedGreenOutputCell<Id> cell;
    cell.Leaf.Cell = this->GetPublicId(index);
    cell.Input = node.Input;
    cell.Dimension = node.Dimension;
    cell.Level = node.Level + (red ? 1 : 0);
    cell.Kind = parts.Kind;
    for (int part = 0; part < parts.Count; ++part)
    {
      if (red && node.FirstChild >= 0 && this->Nodes[node.FirstChild + part].Pattern != 0)
      {
        continue; // it has changed itself
      }
      cell.Leaf.Child = red ? part : -1;
      for (int i = 0; i <= node.Dimension; ++i)
      {
        cell.Vertices[i] = lattice[parts.Vertices[part][i]];
      }
      cells.push_back(cell);
    }
  }
  return cells;
}

template <typename Id>
void RedGreen<Id>::GetLattice(const Node& node, Id* lattice) const
{
  for (int i = 0; i <= node.Dimension; ++i)
  {
    lattice[i] = node.Vertices[i];
  }
  for (int k = 0; k < NumberOfEdges[node.Dimension]; ++k)
  {
    lattice[node.Dimension + 1 + k] =
      node.Edges[k] < 0 ? Id(-1) : this->Edges[node.Edges[k]].Midpoint;
  }
}

template <typename Id>
std::array<Id, 2> RedGreen<Id>::GetEnds(Id vertex) const
{
  const Edge& edge = this->Edges[this->MidpointEdges[vertex - this->InputVertices]];
  return { { edge.Ends[0], edge.Ends[1] } };
}

template <typename Id>
RedGreenOrigin<Id> RedGreen<Id>::GetOrigin(Id vertex) const
{
  const Id use = this->Edges[this->MidpointEdges[vertex - this->InputVertices]].FirstUse;
  return { this->GetPublicId(use / 6), static_cast<int>(use % 6) };
}

template <typename Id>
RedGreenCell<Id> RedGreen<Id>::GetCell(Id cell) const
{
  RedGreenCell<Id> result;
  const Id index = this->FindNode(cell);
  if (index < 0)
  {
    result.Input = cell;
    result.Dimension = this->Input.Dimensions[cell];
    result.Level = this->Input.GetLevel(cell);
    vtkIdType vertices[4];
    this->ReadInput(cell, vertices);
    for (int i = 0; i <= result.Dimension; ++i)
    {
      result.Vertices[i] = static_cast<Id>(vertices[i]);
    }
    return result;
  }
  const Node& node = this->Nodes[index];
  result.Input = node.Input;
  result.Parent = node.Parent < 0 ? Id(-1) : this->GetPublicId(node.Parent);
  result.Child = node.Parent < 0 ? -1 : node.Child;
  result.Dimension = node.Dimension;
  result.Level = node.Level;
  std::copy(node.Vertices, node.Vertices + node.Dimension + 1, result.Vertices.begin());
  return result;
}

template <typename Id>
RedGreenCell<Id> RedGreen<Id>::GetCell(const Leaf& leaf) const
{
  RedGreenCell<Id> result = this->GetCell(leaf.Cell);
  if (leaf.Child >= 0)
  {
    Id lattice[10];
    this->GetLattice(this->Nodes[this->FindNode(leaf.Cell)], lattice);
    const auto& parts = PartsOf[result.Dimension][Full[result.Dimension]];
    for (int i = 0; i <= result.Dimension; ++i)
    {
      result.Vertices[i] = lattice[parts.Vertices[leaf.Child][i]];
    }
    result.Parent = leaf.Cell;
    result.Child = leaf.Child;
    ++result.Level;
  }
  return result;
}

template <typename Id>
std::size_t RedGreen<Id>::GetMemorySize() const
{
  auto size = [](const std::vector<Id>& list) { return list.capacity() * sizeof(Id); };
  return this->Roots.GetMemorySize() + this->Flags.GetMemorySize() + this->Nodes.GetMemorySize() +
    this->Edges.GetMemorySize() + this->EdgesByEnds.GetMemorySize() +
    this->MidpointEdges.GetMemorySize() + this->Queue.GetMemorySize() + size(this->ChangedNodes) +
    size(this->LastChanges) + this->Incidence.GetMemorySize() +
    this->KnownMidpoints.size() * 4 * sizeof(Id);
}

template class RedGreen<int>;
template class RedGreen<long long>;

}
