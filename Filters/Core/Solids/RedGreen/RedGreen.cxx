// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/RedGreen/RedGreen.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/RedGreen/RedGreenTables.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace subdivision
{

using redgreen::Full;
using redgreen::NumberOfEdges;
using redgreen::PartsOf;

namespace
{

/// Whether red children have the edge between the midpoints of two edges of their parent: these
/// meet, or it is the diagonal (Mathematics 2).
bool IsEdgeOfChildren(int k, int l)
{
  return tetrahedron::OppositeEdge(k) != l || k == tetrahedron::MarkedEdges[0] ||
    k == tetrahedron::MarkedEdges[1];
}

}

template <typename Id>
RedGreen<Id>::RedGreen(const SimplexView& cells, std::function<void(vtkIdType*)> orderTet)
  : Input(cells)
  , Places(FindCorners(cells))
  , OrderTet(std::move(orderTet))
  , InputVertices(static_cast<Id>(cells.NumberOfPoints))
  , OutputCells(cells.NumberOfSimplices)
  , Roots(cells.NumberOfSimplices)
  , Flags(cells.NumberOfPoints)
{
  std::fill(this->Flags.begin(), this->Flags.end(), static_cast<unsigned char>(0));
}

template <typename Id>
bool RedGreen<Id>::IsNodeRed(const Node& node)
{
  return node.Dimension > 0 && node.Pattern == Full[node.Dimension];
}

template <typename Id>
bool RedGreen<Id>::IsRed(Id cell) const
{
  const Id node = this->FindNode(cell);
  return node >= 0 && this->IsNodeRed(this->Nodes[node]);
}

// ---- cells come into being -----------------------------------------------------------------

template <typename Id>
Id RedGreen<Id>::GetStored(const Leaf& leaf)
{
  const Id node =
    leaf.Cell < this->Roots.size() ? this->Activate(leaf.Cell) : this->GetChildNode(leaf.Cell);
  if (leaf.Child < 0)
  {
    return node;
  }
  this->Expand(node);
  return this->Nodes[node].FirstChild + leaf.Child;
}

template <typename Id>
void RedGreen<Id>::AddUse(Id index, int k)
{
  Node& node = this->Nodes[index];
  Edge& edge = this->Edges[node.Edges[k]];
  node.NextUse[k] = edge.FirstUse;
  edge.FirstUse = 6 * index + k;
}

/// Applies midpoints that exist already to a new node, or to one whose edges were looked up.
template <typename Id>
void RedGreen<Id>::Settle(Id index)
{
  const Node node = this->Nodes[index];
  unsigned int pattern = 0;
  bool deeper = false;
  for (int k = 0; k < NumberOfEdges[node.Dimension]; ++k)
  {
    if (node.Edges[k] >= 0 && this->Edges[node.Edges[k]].Midpoint >= 0)
    {
      pattern |= 1u << k;
      deeper = deeper || this->IsHalfSplit(node.Edges[k]);
    }
  }
  if (pattern == 0)
  {
    return;
  }
  this->SetPattern(index, pattern);
  if (deeper || (this->InnerEdgesSplit && this->IsInnerEdgeSplit(this->Nodes[index])))
  {
    this->MakeRed(index);
    this->Expand(index);
  }
}

/// Stores the children of a red node.
template <typename Id>
void RedGreen<Id>::Expand(Id index)
{
  if (this->Nodes[index].FirstChild >= 0)
  {
    return;
  }
  const Node node = this->Nodes[index];
  const int dimension = node.Dimension;
  if (node.Level == LastLevel)
  {
    throw std::invalid_argument("The cells below cell " + std::to_string(node.Input) +
      " do not end: midpoints that were given do not fit together.");
  }
  Id lattice[10];
  this->GetLattice(node, lattice);
  // Edges between lattice points, each looked up once.
  Id edges[10][10];
  std::fill(&edges[0][0], &edges[0][0] + 100, Id(-1));
  for (int k = 0; k < NumberOfEdges[dimension]; ++k)
  {
    const int* ends = redgreen::EndsOf(dimension, k);
    const bool turned = this->Edges[node.Edges[k]].Ends[0] != node.Vertices[ends[0]];
    for (int end = 0; end < 2; ++end)
    {
      edges[ends[end]][dimension + 1 + k] = this->GetHalf(node.Edges[k], turned ? 1 - end : end);
    }
  }
  const auto& parts = PartsOf[dimension][Full[dimension]];
  const Id first = static_cast<Id>(this->Nodes.size());
  this->Nodes[index].FirstChild = first;
  for (int child = 0; child < parts.Count; ++child)
  {
    Node made{};
    made.Input = node.Input;
    made.Parent = index;
    made.FirstChild = -1;
    made.Dimension = node.Dimension;
    made.Level = static_cast<unsigned char>(node.Level + 1);
    made.Child = static_cast<unsigned char>(child);
    const signed char* points = parts.Vertices[child];
    for (int i = 0; i <= dimension; ++i)
    {
      made.Vertices[i] = lattice[points[i]];
    }
    for (int k = 0; k < NumberOfEdges[dimension]; ++k)
    {
      const int* ends = redgreen::EndsOf(dimension, k);
      const int a = std::min(points[ends[0]], points[ends[1]]);
      const int b = std::max(points[ends[0]], points[ends[1]]);
      if (edges[a][b] < 0)
      {
        edges[a][b] = this->FindOrAddEdge(lattice[a], lattice[b]);
      }
      made.Edges[k] = edges[a][b];
    }
    this->Nodes.push_back(made);
    for (int k = 0; k < NumberOfEdges[dimension]; ++k)
    {
      this->AddUse(first + child, k);
    }
  }
  for (int child = 0; child < parts.Count; ++child)
  {
    this->Settle(first + child);
  }
}

// ---- edges ---------------------------------------------------------------------------------

template <typename Id>
Id RedGreen<Id>::AddEdge(Id a, Id b)
{
  this->Edges.push_back({ { a, b }, -1, { -1, -1 }, -1 });
  return static_cast<Id>(this->Edges.size() - 1);
}

template <typename Id>
Id RedGreen<Id>::FindOrAddEdge(Id a, Id b)
{
  const Id next = static_cast<Id>(this->Edges.size());
  const Id edge = this->EdgesByEnds.FindOrAdd(a, b, next);
  return edge == next ? this->AddEdge(a, b) : edge;
}

/// The half of a split edge at one of its ends.
template <typename Id>
Id RedGreen<Id>::GetHalf(Id index, int side)
{
  if (this->Edges[index].Halves[0] < 0)
  {
    const Edge edge = this->Edges[index];
    // If the midpoint is an input vertex, the halves may be edges of input cells already.
    const bool known = edge.Midpoint < this->InputVertices;
    for (int i = 0; i < 2; ++i)
    {
      const Id half = known ? this->FindOrAddEdge(edge.Ends[i], edge.Midpoint)
                            : this->AddEdge(edge.Ends[i], edge.Midpoint);
      this->Edges[index].Halves[i] = half;
    }
  }
  return this->Edges[index].Halves[side];
}

/// The edge whose midpoint a vertex is, -1.
template <typename Id>
Id RedGreen<Id>::FindMidpointEdge(Id vertex) const
{
  if (vertex >= this->InputVertices)
  {
    return this->MidpointEdges[vertex - this->InputVertices];
  }
  if (this->KnownMidpoints.empty())
  {
    return -1;
  }
  const auto found = this->KnownMidpoints.find(vertex);
  return found == this->KnownMidpoints.end() ? Id(-1) : found->second;
}

template <typename Id>
bool RedGreen<Id>::IsHalfSplit(Id index)
{
  const Edge& edge = this->Edges[index];
  if (edge.Halves[0] < 0)
  {
    return false;
  }
  return this->Edges[edge.Halves[0]].Midpoint >= 0 || this->Edges[edge.Halves[1]].Midpoint >= 0;
}

/// Whether an edge between midpoints of a face with three split edges, or the diagonal, is split.
template <typename Id>
bool RedGreen<Id>::IsInnerEdgeSplit(const Node& node) const
{
  // Few midpoints are ends of such an edge, and to look for one in the table is slow.
  auto mayBeEnd = [this](Id vertex)
  { return !this->InnerEndsAreKnown || this->InnerEnds[vertex - this->InputVertices]; };
  auto isSplit = [&](int k, int l)
  {
    const Id ends[2] = { this->Edges[node.Edges[k]].Midpoint, this->Edges[node.Edges[l]].Midpoint };
    if (!mayBeEnd(ends[0]) || !mayBeEnd(ends[1]))
    {
      return false;
    }
    const Id edge = this->EdgesByEnds.Find(ends[0], ends[1]);
    return edge >= 0 && this->Edges[edge].Midpoint >= 0;
  };
  if (node.Dimension == 2)
  {
    return node.Pattern == Full[2] && (isSplit(0, 1) || isSplit(1, 2) || isSplit(0, 2));
  }
  if (node.Dimension == 3 && node.Pattern == Full[3] &&
    isSplit(tetrahedron::MarkedEdges[0], tetrahedron::MarkedEdges[1]))
  {
    return true; // by an equal tetrahedron
  }
  for (int face = 0; node.Dimension == 3 && face < 4; ++face)
  {
    const unsigned int pattern = redgreen::FacePattern(face);
    if ((node.Pattern & pattern) != pattern)
    {
      continue;
    }
    const int* corners = tetrahedron::FaceVertices[face];
    for (int i = 0; i < 3; ++i)
    {
      const int corner = corners[i];
      if (isSplit(tetrahedron::EdgeOf[corner][corners[(i + 1) % 3]],
            tetrahedron::EdgeOf[corner][corners[(i + 2) % 3]]))
      {
        return true;
      }
    }
  }
  return false;
}

// ---- midpoints spread ----------------------------------------------------------------------

template <typename Id>
void RedGreen<Id>::Split(Id index)
{
  Edge& edge = this->Edges[index];
  if (edge.Midpoint >= 0)
  {
    return;
  }
  edge.Midpoint = this->GetNumberOfVertices();
  if (this->FindMidpointEdge(edge.Ends[0]) >= 0 && this->FindMidpointEdge(edge.Ends[1]) >= 0)
  {
    this->InnerEdgesSplit = true;
    for (const Id end : edge.Ends)
    {
      if (end >= this->InputVertices)
      {
        this->InnerEnds[end - this->InputVertices] = true;
      }
    }
  }
  this->MidpointEdges.push_back(index);
  this->InnerEnds.push_back(false);
  this->Queue.push_back(index);
  this->FlagEnds(edge);
}

/// Adds split edges to the pattern of a node, closes the pattern and splits its edges.
template <typename Id>
void RedGreen<Id>::SetPattern(Id index, unsigned int pattern)
{
  Node& node = this->Nodes[index];
  const auto& table = PartsOf[node.Dimension];
  const unsigned int closed = table[node.Pattern | pattern].Closed;
  if (closed == node.Pattern)
  {
    return;
  }
  if (this->GetScope(node.Input) == CellScope::Own)
  {
    this->OutputCells += table[closed].Count - table[node.Pattern].Count;
  }
  node.Pattern = static_cast<unsigned char>(closed);
  if (!node.Changed)
  {
    node.Changed = true;
    this->ChangedNodes.push_back(index);
  }
  for (int k = 0; k < NumberOfEdges[node.Dimension]; ++k)
  {
    if (closed >> k & 1u)
    {
      this->Split(this->GetEdge(index, k));
    }
  }
}

template <typename Id>
void RedGreen<Id>::MakeRed(Id node)
{
  this->SetPattern(node, Full[this->Nodes[node].Dimension]);
}

/// Passes a split edge on to the cells at it.
template <typename Id>
void RedGreen<Id>::Spread(Id edge)
{
  for (Id use = this->Edges[edge].FirstUse; use >= 0;)
  {
    const Id node = use / 6;
    const int k = static_cast<int>(use % 6);
    this->SetPattern(node, 1u << k);
    use = this->Nodes[node].NextUse[k];
  }
  this->SpreadToParents(edge);
}

/// If a split edge can only be an edge of a red child, its parents must be red. It is a half of an
/// edge, and all cells with that edge become red, or it joins the midpoints of two edges, and all
/// cells with both edges become red.
template <typename Id>
void RedGreen<Id>::SpreadToParents(Id edge)
{
  const Id ends[2] = { this->Edges[edge].Ends[0], this->Edges[edge].Ends[1] };
  const Id parents[2] = { this->FindMidpointEdge(ends[0]), this->FindMidpointEdge(ends[1]) };
  for (int i = 0; i < 2; ++i)
  {
    if (parents[i] >= 0)
    {
      const Edge& parent = this->Edges[parents[i]];
      if (parent.Ends[0] == ends[1 - i] || parent.Ends[1] == ends[1 - i])
      {
        this->MakeUsersRed(parents[i], -1);
        return;
      }
    }
  }
  if (parents[0] >= 0 && parents[1] >= 0)
  {
    this->MakeUsersRed(parents[0], parents[1]);
  }
}

/// Makes all nodes red that have an edge and, unless it is -1, a second one.
template <typename Id>
void RedGreen<Id>::MakeUsersRed(Id edge, Id second)
{
  for (Id use = this->Edges[edge].FirstUse; use >= 0;)
  {
    const Id index = use / 6;
    const Node& node = this->Nodes[index];
    use = node.NextUse[use % 6];
    const Id* edges = node.Edges;
    if (second < 0 ||
      std::find(edges, edges + NumberOfEdges[node.Dimension], second) !=
        edges + NumberOfEdges[node.Dimension])
    {
      this->MakeRed(index);
      this->Expand(index);
    }
  }
}

// ---- a round -------------------------------------------------------------------------------

template <typename Id>
void RedGreen<Id>::AddMidpoint(Id end0, Id end1, Id midpoint)
{
  const Id edge = this->FindOrAddEdge(end0, end1);
  if (this->Edges[edge].Midpoint >= 0)
  {
    return;
  }
  this->Edges[edge].Midpoint = midpoint;
  this->KnownMidpoints.emplace(midpoint, edge);
  this->InnerEdgesSplit = true; // is not known, so assume it
  this->InnerEndsAreKnown = false;
  this->GetHalf(edge, 0);
  this->Queue.push_back(edge);
  this->FlagEnds(this->Edges[edge]);
}

template <typename Id>
void RedGreen<Id>::MarkCell(const Leaf& leaf)
{
  this->MakeRed(this->GetStored(leaf));
}

template <typename Id>
void RedGreen<Id>::MarkEdge(const Leaf& leaf, Id end0, Id end1)
{
  const Id index = this->GetStored(leaf);
  const Node node = this->Nodes[index];
  for (int k = 0; k < NumberOfEdges[node.Dimension]; ++k)
  {
    const int* ends = redgreen::EndsOf(node.Dimension, k);
    const Id a = node.Vertices[ends[0]];
    const Id b = node.Vertices[ends[1]];
    if ((a == end0 && b == end1) || (a == end1 && b == end0))
    {
      this->SetPattern(index, 1u << k);
      return;
    }
  }
  this->MakeRed(index);
  // An edge of a red child stays and is split; any other edge vanishes.
  const Id parents[2] = { this->FindMidpointEdge(end0), this->FindMidpointEdge(end1) };
  const Id ends[2] = { end0, end1 };
  auto find = [&](Id edge)
  {
    return static_cast<int>(
      std::find(node.Edges, node.Edges + NumberOfEdges[node.Dimension], edge) - node.Edges);
  };
  auto has = [&](Id edge) { return edge >= 0 && find(edge) < NumberOfEdges[node.Dimension]; };
  for (int i = 0; i < 2; ++i)
  {
    for (int side = 0; has(parents[i]) && side < 2; ++side)
    {
      if (this->Edges[parents[i]].Ends[side] == ends[1 - i])
      {
        this->Split(this->GetHalf(parents[i], side));
        return;
      }
    }
  }
  if (has(parents[0]) && has(parents[1]) && IsEdgeOfChildren(find(parents[0]), find(parents[1])))
  {
    this->Split(this->FindOrAddEdge(end0, end1));
  }
}

template <typename Id>
void RedGreen<Id>::Propagate()
{
  this->HasSplit = this->HasSplit || !this->Queue.empty();
  Turns turns;
  for (;;)
  {
    while (!this->Queue.empty())
    {
      turns.Next();
      const Id edge = this->Queue.back();
      this->Queue.pop_back();
      this->Spread(edge);
    }
    if (this->NewFlags.empty())
    {
      break;
    }
    this->ActivateNearFlags();
  }
}

template <typename Id>
bool RedGreen<Id>::Close()
{
  this->Propagate();
  std::swap(this->LastChanges, this->ChangedNodes);
  this->ChangedNodes.clear();
  for (Id node : InTurn(this->LastChanges))
  {
    this->Nodes[node].Changed = false;
  }
  return std::exchange(this->HasSplit, false);
}

SUBDIVISION_COMPILE(class RedGreen);

}
