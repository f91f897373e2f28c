// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/SharedSplits.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"

#include <algorithm>

namespace subdivision
{

std::vector<CellScope> FindScopes(const RedGreenMesh& mesh, const OtherPartitions& others)
{
  const SimplexView view = mesh.GetView();
  const SimplexStarts places = FindCorners(view);
  const vtkIdType size = view.NumberOfSimplices;
  const auto points = [&](vtkIdType i)
  { return Row<vtkIdType>{ view.Connectivity + places[i], view.Connectivity + places[i + 1] }; };
  std::vector<char> isOfOwn(view.NumberOfPoints, 0);
  for (const vtkIdType i : InTurn(size))
  {
    for (const vtkIdType point : points(i))
    {
      isOfOwn[point] = isOfOwn[point] || others.IsOwn(mesh.GetInputCell(i));
    }
  }
  std::vector<CellScope> scopes(size, CellScope::Ignored);
  for (vtkIdType begin = 0; begin < size;) // all simplices of a cell are alike
  {
    const vtkIdType cell = mesh.GetInputCell(begin);
    CellScope scope = CellScope::Ignored;
    vtkIdType end = begin;
    for (; end < size && mesh.GetInputCell(end) == cell; ++end)
    {
      const auto own = points(end);
      const bool isBeside =
        std::any_of(own.begin(), own.end(), [&](vtkIdType point) { return isOfOwn[point] != 0; });
      scope = isBeside ? CellScope::Copied : scope;
    }
    scope = others.IsOwn(cell) ? CellScope::Own : scope;
    std::fill(scopes.begin() + begin, scopes.begin() + end, scope);
    begin = end;
  }
  return scopes;
}

template <typename Id>
SharedSplits<Id>::SharedSplits(const RedGreenMesh& mesh, OtherPartitions& others)
  : Mesh(mesh)
  , Others(others)
  , NumberOfPoints(static_cast<Id>(others.GetPointIds().size()))
{
  this->NameCentres();
}

// ------------------------------------------------------------------------------------------------
// Names

/// A hash of two names, which may come in any order.
template <typename Id>
typename SharedSplits<Id>::Name SharedSplits<Id>::Mix(const Name& a, const Name& b)
{
  const Name& less = a < b ? a : b;
  const Name& more = a < b ? b : a;
  // Two hashes of the same four numbers.
  std::uint64_t hash[2] = { 0x9E3779B97F4A7C15ull, 0xC2B2AE3D27D4EB4Full };
  for (const std::uint64_t number : { less.First, less.Second, more.First, more.Second })
  {
    for (int i = 0; i < 2; ++i)
    {
      hash[i] ^= number + (i == 0 ? 0ull : 0x165667B19E3779F9ull);
      hash[i] *= i == 0 ? 0xBF58476D1CE4E5B9ull : 0xD6E8FEB86659FD93ull;
      hash[i] ^= hash[i] >> (i == 0 ? 29 : 32);
      hash[i] *= i == 0 ? 0x94D049BB133111EBull : 0xFF51AFD7ED558CCDull;
      hash[i] ^= hash[i] >> (i == 0 ? 32 : 31);
    }
  }
  return { hash[0], hash[1] | 1u };
}

/// Names centres by their points. Another one around the same points, of an equal cell, gets the
/// next name.
template <typename Id>
void SharedSplits<Id>::NameCentres()
{
  const SimplicesOfCells& cells = this->Mesh.Control.Cells;
  for (const vtkIdType c : InTurn(cells.GetNumberOfCentres()))
  {
    std::vector<vtkIdType> members(cells.CentreMembers.begin() + cells.CentreOffsets[c],
      cells.CentreMembers.begin() + cells.CentreOffsets[c + 1]);
    std::sort(members.begin(), members.end());
    Name name = { members.size(), 2 };
    for (const vtkIdType member : members)
    {
      name = Mix(name, this->GetName(static_cast<Id>(member)));
    }
    while (this->Vertices.count(name) > 0)
    {
      name = Mix(name, name);
    }
    this->Vertices[name] = this->NumberOfPoints + static_cast<Id>(c);
    this->Names.push_back(name);
  }
}

template <typename Id>
typename SharedSplits<Id>::Name SharedSplits<Id>::GetName(Id vertex) const
{
  return vertex < this->NumberOfPoints
    ? Name{ static_cast<std::uint64_t>(this->Others.GetPointIds()[vertex]), 0 }
    : this->Names[vertex - this->NumberOfPoints];
}

/// The vertex of a name, -1.
template <typename Id>
Id SharedSplits<Id>::Find(const Name& name) const
{
  if (name.Second != 0)
  {
    const auto found = this->Vertices.find(name);
    return found == this->Vertices.end() ? Id(-1) : found->second;
  }
  const std::vector<vtkIdType>& ids = this->Others.GetPointIds();
  const auto id = static_cast<vtkIdType>(name.First);
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  return found == ids.end() || *found != id ? Id(-1) : static_cast<Id>(found - ids.begin());
}

template <typename Id>
void SharedSplits<Id>::NameNew(const RedGreen<Id>& state)
{
  for (auto v = static_cast<Id>(this->NumberOfPoints + this->Names.size());
    v < state.GetNumberOfVertices(); ++v)
  {
    const auto ends = state.GetEnds(v);
    const Name name = Mix(this->GetName(ends[0]), this->GetName(ends[1]));
    this->Names.push_back(name);
    this->Vertices.emplace(name, v);
  }
}

// ------------------------------------------------------------------------------------------------
// Messages

/// The splits that no other partition was told of, for the partitions that have copies of the
/// cells.
template <typename Id>
typename SharedSplits<Id>::Splits SharedSplits<Id>::TakeNew(const RedGreen<Id>& state)
{
  this->NameNew(state);
  Splits splits;
  std::vector<int> to;
  this->NextToSend = std::max(this->NextToSend, state.GetNumberOfInputVertices());
  for (; this->NextToSend < state.GetNumberOfVertices(); ++this->NextToSend)
  {
    to.clear();
    state.ForInputCells(this->NextToSend,
      [&](Id simplex)
      {
        const vtkIdType cell = this->Mesh.GetInputCell(simplex);
        if (this->Others.IsOwn(cell))
        {
          const std::vector<int>& neighbours = this->Others.GetNeighbours(cell);
          to.insert(to.end(), neighbours.begin(), neighbours.end());
        }
      });
    SortDistinct(to);
    const auto ends = state.GetEnds(this->NextToSend);
    for (const int partition : to)
    {
      splits[partition].push_back({ { this->GetName(ends[0]), this->GetName(ends[1]) } });
    }
  }
  return splits;
}

/// Splits the edges that others have split. A sender names the ends of an edge before the edge.
template <typename Id>
void SharedSplits<Id>::Receive(const Splits& splits, RedGreen<Id>& state)
{
  for (const auto& [from, list] : splits)
  {
    for (const Split& split : list)
    {
      const Id ends[2] = { this->Find(split.Ends[0]), this->Find(split.Ends[1]) };
      if (ends[0] >= 0 && ends[1] >= 0 && state.SplitEdge(ends[0], ends[1]))
      {
        this->NameNew(state);
      }
    }
  }
}

template <typename Id>
void SharedSplits<Id>::Close(RedGreen<Id>& state)
{
  for (;;)
  {
    state.Propagate();
    Splits splits = this->TakeNew(state);
    if (!this->Others.SendLists(splits))
    {
      break;
    }
    this->Receive(splits, state);
  }
  state.Close();
}

SUBDIVISION_COMPILE(class SharedSplits);

}
