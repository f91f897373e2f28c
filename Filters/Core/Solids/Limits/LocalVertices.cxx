// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LocalVertices.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>

namespace subdivision
{
namespace
{

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

}

template <typename Id>
LocalVertices<Id>::LocalVertices(
  Id first, const std::vector<std::array<Id, 2>>& midpoints, const Buffer<unsigned char>& wanted)
  : First(first)
  , Midpoints(midpoints)
{
  this->FindLevels();
  this->FindAncestors();
  this->Wanted.resize(this->Born.size());
  for (std::size_t level = 0; level < this->Born.size(); ++level)
  {
    for (const Id vertex : InTurn(this->Born[level]))
    {
      if (wanted.empty() || wanted[vertex])
      {
        this->Wanted[level].push_back(vertex);
      }
    }
  }
}

template <typename Id>
void LocalVertices<Id>::FindLevels()
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

template <typename Id>
void LocalVertices<Id>::FindAncestors()
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

template <typename Id>
void LocalVertices<Id>::StartOnControl()
{
  this->At.assign(this->Levels.size(), -1);
  for (Id v = 0; v < this->First; ++v)
  {
    this->At[v] = v;
  }
}

template <typename Id>
Buffer<Id> LocalVertices<Id>::FindWantedOnPart(std::size_t level) const
{
  const std::vector<Id>& wanted = this->Wanted[level];
  Buffer<Id> vertices(static_cast<vtkIdType>(wanted.size()));
  std::transform(
    wanted.begin(), wanted.end(), vertices.begin(), [this](Id vertex) { return this->At[vertex]; });
  return vertices;
}

template <typename Id>
template <typename LevelType>
Buffer<unsigned char> LocalVertices<Id>::FlagSupport(
  const LevelType& part, std::size_t level, int distance) const
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

template <typename Id>
template <typename LevelType>
void LocalVertices<Id>::FollowToPart(
  const LevelType& part, const Buffer<Id>& vertices, std::size_t level)
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

SUBDIVISION_COMPILE(class LocalVertices);
#define SUBDIVISION_FOLLOW(Level)                                                                  \
  template Buffer<unsigned char> LocalVertices<Level::IdType>::FlagSupport(                        \
    const Level&, std::size_t, int) const;                                                         \
  template void LocalVertices<Level::IdType>::FollowToPart(                                        \
    const Level&, const Buffer<Level::IdType>&, std::size_t)
SUBDIVISION_FOLLOW(Level<int>);
SUBDIVISION_FOLLOW(Level<long long>);
SUBDIVISION_FOLLOW(TetOctLevel<int>);
SUBDIVISION_FOLLOW(TetOctLevel<long long>);

}
