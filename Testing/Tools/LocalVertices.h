// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalVertices.h
 * The vertices of parts of levels, for LimitByLevels.h, each by the vertices between which it
 * arises.
 */
#ifndef SubdivisionObjects_LocalVertices_h
#define SubdivisionObjects_LocalVertices_h

#include "Core/Memory/Sorting.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

namespace coretest
{

using namespace subdivision;

/// Calls act(its two ends, octahedron) for each diagonal of the octahedra of a level.
template <typename Id, typename Act>
void ForDiagonals(const Level<Id>&, const Act&)
{
}
template <typename Id, typename Act>
void ForDiagonals(const TetOctLevel<Id>& level, const Act& act)
{
  ForEachInTurn(3 * vtkIdType(level.NumberOfOctahedra),
    [&](vtkIdType d) { act(level.OctVertices.data() + 2 * d, static_cast<Id>(d / 3)); });
}

/**
 * The vertices are those of a control level and midpoints, each named by its ends, or vertices once
 * more on the next level, named by two equal ends. The *ancestors* of a
 * level are the ends of the edges whose midpoints first exist on the next level, and those
 * ancestors of the next level that exist already.
 */
template <typename Id>
class LocalVertices
{
public:
  /// `first`: the number of the first midpoint; the others as in the constructor of LimitByLevels.
  /// Throws std::invalid_argument if an end is not an earlier vertex.
  LocalVertices(Id first, const std::vector<std::array<Id, 2>>& midpoints)
    : First(first)
    , Midpoints(midpoints)
  {
    this->FindLevels();
    this->FindAncestors();
  }

  /// The control level, and the levels on which midpoints first exist.
  std::size_t GetNumberOfLevels() const { return this->Born.size(); }
  /// The vertices that first exist on a level.
  const std::vector<Id>& GetBorn(std::size_t level) const { return this->Born[level]; }

  // The current part of a level. At first it is the whole control level.
  void StartOnControl()
  {
    this->At.assign(this->Levels.size(), -1);
    for (Id v = 0; v < this->First; ++v)
    {
      this->At[v] = v;
    }
  }
  /// The numbers on the current part of the vertices that first exist on its level.
  Buffer<Id> FindOnPart(std::size_t level) const
  {
    const std::vector<Id>& born = this->Born[level];
    Buffer<Id> vertices(static_cast<vtkIdType>(born.size()));
    std::transform(
      born.begin(), born.end(), vertices.begin(), [this](Id vertex) { return this->At[vertex]; });
    return vertices;
  }
  /// Flags the ancestors and all vertices within `distance` steps of them, along edges and across
  /// octahedra. `part` is the current one.
  template <typename LevelType>
  Buffer<unsigned char> FlagSupport(const LevelType& part, std::size_t level, int distance) const
  {
    const SimplicialComplex<Id>& complex = part.Complex;
    Buffer<unsigned char> flags(complex.NumberOfVertices, 0);
    for (Id vertex : this->Ancestors[level])
    {
      flags[this->At[vertex]] = 1;
    }
    for (int step = 1; step <= distance; ++step)
    {
      const auto spread = [&](const Id* ends)
      {
        for (int i = 0; i < 2; ++i)
        {
          if (flags[ends[i]] > 0 && flags[ends[i]] <= step && flags[ends[1 - i]] == 0)
          {
            flags[ends[1 - i]] = static_cast<unsigned char>(std::min(step + 1, 255));
          }
        }
      };
      ForEachInTurn(
        complex.NumberOfEdges, [&](vtkIdType e) { spread(complex.EdgeVertices.data() + 2 * e); });
      ForDiagonals(part, [&](const Id* ends, Id) { spread(ends); });
    }
    return flags;
  }
  /// Goes on to a part of the current part, where vertices have the numbers `vertices`: finds the
  /// ancestors in it, and the numbers that vertices of the next level will have when it is refined.
  /// Throws std::invalid_argument if there is no edge between the ends of one of these.
  template <typename LevelType>
  void FollowToPart(const LevelType& part, const Buffer<Id>& vertices, std::size_t level)
  {
    const SimplicialComplex<Id>& complex = part.Complex;
    std::vector<unsigned char> isAncestor(complex.NumberOfVertices, 0);
    for (const Id vertex : InTurn(this->Ancestors[level]))
    {
      this->At[vertex] = vertices[this->At[vertex]];
      isAncestor[this->At[vertex]] = 1;
    }
    std::vector<std::tuple<Id, Id, Id>> edges; // and diagonals: ends, vertex between
    const auto add = [&](const Id* ends, Id middle)
    {
      const auto [a, b] = std::minmax(ends[0], ends[1]);
      if (isAncestor[a] && isAncestor[b])
      {
        edges.emplace_back(a, b, complex.NumberOfVertices + middle);
      }
    };
    for (const Id e : InTurn(complex.NumberOfEdges))
    {
      add(complex.EdgeVertices.data() + 2 * vtkIdType(e), e);
    }
    ForDiagonals(part, [&](const Id* ends, Id oct) { add(ends, complex.NumberOfEdges + oct); });
    StableSort(edges, std::less<>());
    for (const Id vertex : InTurn(this->Born[level + 1]))
    {
      const std::array<Id, 2>& ends = this->GetEnds(vertex);
      if (ends[0] == ends[1])
      {
        this->At[vertex] = this->At[ends[0]];
        continue;
      }
      const auto [a, b] = std::minmax(this->At[ends[0]], this->At[ends[1]]);
      const auto edge = std::lower_bound(edges.begin(), edges.end(), std::make_tuple(a, b, Id(0)));
      if (edge == edges.end() || std::get<0>(*edge) != a || std::get<1>(*edge) != b)
      {
        throw std::invalid_argument("There is no edge between the vertices " +
          std::to_string(ends[0]) + " and " + std::to_string(ends[1]) + " on level " +
          std::to_string(level) + ".");
      }
      this->At[vertex] = std::get<2>(*edge);
    }
  }

private:
  void FindLevels()
  {
    this->Levels.assign(this->Midpoints.size() + this->First, 0);
    this->Born.resize(1);
    for (Id v = 0; v < this->First; ++v)
    {
      this->Born[0].push_back(v);
    }
    for (const std::size_t i : InTurn(this->Midpoints.size()))
    {
      const Id vertex = this->First + static_cast<Id>(i);
      const auto [a, b] = this->Midpoints[i];
      if (a < 0 || b < 0 || a >= vertex || b >= vertex)
      {
        throw std::invalid_argument("Midpoint " + std::to_string(vertex) + " has the ends " +
          std::to_string(a) + " and " + std::to_string(b) + ", which must be earlier vertices.");
      }
      const std::size_t level = 1 + std::max(this->Levels[a], this->Levels[b]);
      this->Levels[vertex] = static_cast<int>(level);
      this->Born.resize(std::max(this->Born.size(), level + 1));
      this->Born[level].push_back(vertex);
    }
  }
  void FindAncestors()
  {
    this->Ancestors.resize(this->Born.size());
    std::vector<bool> isAncestor(this->Levels.size(), false);
    for (std::size_t level = this->Born.size() - 1; level-- > 0;)
    {
      std::vector<Id>& ancestors = this->Ancestors[level];
      auto add = [&](Id vertex)
      {
        if (this->Levels[vertex] <= static_cast<int>(level) && !isAncestor[vertex])
        {
          isAncestor[vertex] = true;
          ancestors.push_back(vertex);
        }
      };
      for (const Id vertex : InTurn(this->Ancestors[level + 1]))
      {
        add(vertex);
      }
      for (const Id vertex : InTurn(this->Born[level + 1]))
      {
        add(this->GetEnds(vertex)[0]);
        add(this->GetEnds(vertex)[1]);
      }
      for (Id vertex : ancestors)
      {
        isAncestor[vertex] = false;
      }
    }
  }

  const std::array<Id, 2>& GetEnds(Id midpoint) const
  {
    return this->Midpoints[static_cast<std::size_t>(midpoint - this->First)];
  }

  const Id First;
  const std::vector<std::array<Id, 2>>& Midpoints;
  std::vector<int> Levels;                ///< on which vertices first exist
  std::vector<std::vector<Id>> Born;      ///< vertices by level
  std::vector<std::vector<Id>> Ancestors; ///< by level
  std::vector<Id> At; ///< number on the current part of each ancestor and newest vertex
};

}

#endif
