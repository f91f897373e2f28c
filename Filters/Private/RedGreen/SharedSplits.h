// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedSplits.h
 * Red-green refinement of a mesh of which several partitions have parts.
 */
#ifndef SubdivisionObjects_SharedSplits_h
#define SubdivisionObjects_SharedSplits_h

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/RedGreen/RedGreen.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/RedGreen/RedGreenMesh.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace subdivision
{

/// The part of each simplex in the state of a partition: own cells count, cells that share a point
/// with them are split too, so that errors at own edges have all their triangles, all others stay.
inline std::vector<CellScope> FindScopes(const RedGreenMesh& mesh, const OtherPartitions& others)
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

/**
 * Passes on splits between the states of the partitions. Each sends the new midpoints in its own
 * cells to the partitions that have copies of these cells; edges that arrive are split there, and
 * spread; and so on, until nobody has anything new. As the set of split edges does not depend on
 * the order of marks, it is then the same as in the whole mesh.
 *
 * A vertex is known to others by its name: a point by its id, a midpoint by a hash of the names of
 * its ends, the centre of a cell by a hash of the names of the points around it. 128 bits make it
 * unlikely that two vertices ever get the same name: less than 1e-18 for 1e10 vertices.
 */
template <typename Id>
class SharedSplits
{
public:
  SharedSplits(const RedGreenMesh& mesh, OtherPartitions& others)
    : Mesh(mesh)
    , Others(others)
    , NumberOfPoints(static_cast<Id>(others.GetPointIds().size()))
  {
    this->NameCentres();
  }
  /// Ends a round of the state, as RedGreen::Close does.
  void Close(RedGreen<Id>& state)
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

private:
  struct Name
  {
    std::uint64_t First = 0;
    std::uint64_t Second = 0; ///< 0: First is the id of a point

    bool operator<(const Name& other) const
    {
      return this->First != other.First ? this->First < other.First : this->Second < other.Second;
    }
    bool operator==(const Name& other) const
    {
      return this->First == other.First && this->Second == other.Second;
    }
  };
  struct HashOfName
  {
    std::size_t operator()(const Name& name) const { return static_cast<std::size_t>(name.First); }
  };
  struct Split
  {
    Name Ends[2];
  };
  /// A hash of two names, which may come in any order.
  static Name Mix(const Name& a, const Name& b)
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
  void NameCentres()
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
  Name GetName(Id vertex) const
  {
    return vertex < this->NumberOfPoints
      ? Name{ static_cast<std::uint64_t>(this->Others.GetPointIds()[vertex]), 0 }
      : this->Names[vertex - this->NumberOfPoints];
  }
  /// The vertex of a name, -1.
  Id Find(const Name& name) const
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
  void NameNew(const RedGreen<Id>& state)
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

  using Splits = Exchange::Lists<Split>;
  /// The splits that no other partition was told of, for the partitions that have copies of the
  /// cells.
  Splits TakeNew(const RedGreen<Id>& state)
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
  void Receive(const Splits& splits, RedGreen<Id>& state)
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

  const RedGreenMesh& Mesh;
  OtherPartitions& Others;
  Id NumberOfPoints;
  Id NextToSend = -1;
  std::vector<Name> Names; ///< of centres and new vertices
  std::unordered_map<Name, Id, HashOfName> Vertices;
};

/// A state, which may be a part of a larger one.
template <typename Id>
struct SharedState
{
  std::unique_ptr<RedGreen<Id>> State;
  std::unique_ptr<SharedSplits<Id>> Splits; ///< null: it has all cells

  /// Ends a round.
  void Close()
  {
    if (this->Splits)
    {
      this->Splits->Close(*this->State);
    }
    else
    {
      this->State->Close();
    }
  }
};

}

#endif
