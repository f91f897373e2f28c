// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/RedGreen/RedGreen.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/RedGreen/RedGreenTables.h"

#include <algorithm>
#include <numeric>

namespace subdivision
{

using redgreen::Full;
using redgreen::NumberOfEdges;
using redgreen::PartsOf;

/// Calls use(part) for each part of a changed node that is a cell of the output, and not itself a
/// changed node.
template <typename Id>
template <typename Use>
void RedGreen<Id>::ForChangedParts(Id index, int steps, const Use& use) const
{
  const Node& node = this->Nodes[index];
  const bool red = this->IsNodeRed(node);
  if (node.Level + (red ? 1 : 0) - this->Input.GetLevel(node.Input) >= steps)
  {
    return;
  }
  for (int part = 0; part < PartsOf[node.Dimension][node.Pattern].Count; ++part)
  {
    if (!red || node.FirstChild < 0 || this->Nodes[node.FirstChild + part].Pattern == 0)
    {
      use(part);
    }
  }
}

template <typename Id>
Buffer<RedGreenOutputCell<Id>> RedGreen<Id>::GetChangedCells(int steps) const
{
  const auto changes = static_cast<vtkIdType>(this->LastChanges.size());
  Buffer<vtkIdType> places(changes + 1);
  ForEach(changes,
    [&](vtkIdType i)
    {
      places[i] = 0;
      this->ForChangedParts(this->LastChanges[i], steps, [&](int) { ++places[i]; });
    });
  CountsToOffsets(places);
  Buffer<RedGreenOutputCell<Id>> cells(places[changes]);
  ForEach(changes,
    [&](vtkIdType i)
    {
      if (places[i] == places[i + 1])
      {
        return;
      }
      const Id index = this->LastChanges[i];
      const Node& node = this->Nodes[index];
      const bool red = this->IsNodeRed(node);
      const auto& parts = PartsOf[node.Dimension][node.Pattern];
      Id lattice[10];
      this->GetLattice(node, lattice);
      RedGreenOutputCell<Id> cell;
      cell.Leaf.Cell = this->GetPublicId(index);
      cell.Input = node.Input;
      cell.Dimension = node.Dimension;
      cell.Level = node.Level + (red ? 1 : 0);
      cell.Kind = parts.Kind;
      vtkIdType place = places[i];
      this->ForChangedParts(index, steps,
        [&](int part)
        {
          cell.Leaf.Child = red ? part : -1;
          for (int k = 0; k <= node.Dimension; ++k)
          {
            cell.Vertices[k] = lattice[parts.Vertices[part][k]];
          }
          cells[place++] = cell;
        });
    });
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
void RedGreen<Id>::SortVertices()
{
  struct Vertex
  {
    Id Ends[2];
    Id Edge;
    bool operator<(const Vertex& other) const
    {
      return this->Ends[0] != other.Ends[0] ? this->Ends[0] < other.Ends[0]
                                            : this->Ends[1] < other.Ends[1];
    }
  };
  const Id given = this->InputVertices;
  Buffer<Id> numbers(this->GetNumberOfVertices());
  std::iota(numbers.begin(), numbers.begin() + given, Id(0));
  Id next = given;
  std::vector<Vertex> order;
  for (const std::vector<Id>& added : ListByHalvings(*this))
  {
    Id least = next;
    Id most = 0;
    order.clear();
    order.reserve(added.size());
    for (const Id vertex : added)
    {
      const Id edge = this->MidpointEdges[vertex - given];
      const Id ends[2] = { numbers[this->Edges[edge].Ends[0]], numbers[this->Edges[edge].Ends[1]] };
      order.push_back({ { std::min(ends[0], ends[1]), std::max(ends[0], ends[1]) }, edge });
      least = std::min(least, order.back().Ends[0]);
      most = std::max(most, order.back().Ends[0]);
    }
    const auto range = vtkIdType(most) - least + 1;
    if (range > 8 * static_cast<vtkIdType>(order.size())) // lists would be empty, most of them
    {
      std::sort(order.begin(), order.end());
      for (const Vertex& vertex : order)
      {
        numbers[this->Edges[vertex.Edge].Midpoint] = next++;
      }
      continue;
    }
    // Listed by their first ends they are nearly sorted, as a vertex has few edges.
    Rows<Id> lists = ListByRow<Id>(
      range, static_cast<vtkIdType>(order.size()), [&](vtkIdType i)
      { return order[i].Ends[0] - least; }, [](vtkIdType i) { return static_cast<Id>(i); });
    for (const vtkIdType list : InTurn(lists.GetNumberOfRows()))
    {
      std::sort(lists.Items.data() + lists.Offsets[list],
        lists.Items.data() + lists.Offsets[list + 1],
        [&](Id a, Id b) { return order[a].Ends[1] < order[b].Ends[1]; });
    }
    for (const Id i : lists.Items)
    {
      numbers[this->Edges[order[i].Edge].Midpoint] = next++;
    }
  }
  ForEach(this->Edges.size(),
    [&](vtkIdType e)
    {
      Edge& edge = this->Edges[e];
      edge.Ends[0] = numbers[edge.Ends[0]];
      edge.Ends[1] = numbers[edge.Ends[1]];
      edge.Midpoint = edge.Midpoint < 0 ? edge.Midpoint : numbers[edge.Midpoint];
    });
  const Buffer<Id> edges = this->MidpointEdges.Copy();
  ForEach(
    edges.size(), [&](vtkIdType i) { this->MidpointEdges[numbers[given + i] - given] = edges[i]; });
  ForEach(this->Nodes.size(),
    [&](vtkIdType n)
    {
      Node& node = this->Nodes[n];
      for (int i = 0; i <= node.Dimension; ++i)
      {
        node.Vertices[i] = numbers[node.Vertices[i]];
      }
    });
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
    this->MidpointEdges.GetMemorySize() + this->InnerEnds.GetMemorySize() +
    this->Queue.GetMemorySize() + size(this->ChangedNodes) + size(this->LastChanges) +
    this->Incidence.GetMemorySize() + this->KnownMidpoints.size() * 4 * sizeof(Id);
}

SUBDIVISION_COMPILE(class RedGreen);

}
