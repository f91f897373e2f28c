// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalVertices.h
 * The vertices of a local refinement by the levels of the uniform refinement, and where they are on
 * the part of a level that is made of it (LocalLimit.h).
 */
#ifndef SubdivisionObjects_LocalVertices_h
#define SubdivisionObjects_LocalVertices_h

#include "Core/Solids/Limits/Restriction.h"

#include <array>
#include <cstddef>
#include <vector>

namespace subdivision
{

/**
 * The vertices are those of a control level and midpoints, each named by its ends, or vertices once
 * more on the next level, named by two equal ends. Some of them are wanted. The *ancestors* of a
 * level are the ends of the edges whose midpoints first exist on the next level, and those
 * ancestors of the next level that exist already.
 */
template <typename Id>
class LocalVertices
{
public:
  /// `first`: the number of the first midpoint; the others as in the constructor of LocalLimit.
  /// Throws std::invalid_argument if an end is not an earlier vertex.
  LocalVertices(
    Id first, const std::vector<std::array<Id, 2>>& midpoints, const Buffer<unsigned char>& wanted);

  /// The control level, and the levels on which midpoints first exist.
  std::size_t GetNumberOfLevels() const { return this->Born.size(); }
  /// The wanted vertices that first exist on a level.
  const std::vector<Id>& GetWanted(std::size_t level) const { return this->Wanted[level]; }

  /// The level on which a vertex first exists.
  int GetLevel(Id vertex) const { return this->Levels[vertex]; }

  // The current part of a level. At first it is the whole control level.

  void StartOnControl();

  /// The numbers on the current part of the wanted vertices that first exist on its level.
  Buffer<Id> FindWantedOnPart(std::size_t level) const;

  /// The number on the current part of an ancestor of the level before, or a vertex that first
  /// exists on this level.
  Id GetPlace(Id vertex) const { return this->At[vertex]; }

  /// Flags the ancestors and all vertices within `distance` steps of them, along edges and across
  /// octahedra. `part` is the current one.
  template <typename LevelType>
  Buffer<unsigned char> FlagSupport(const LevelType& part, std::size_t level, int distance) const;

  /// Goes on to a part of the current part, where vertices have the numbers `vertices`: finds the
  /// ancestors in it, and the numbers that vertices of the next level will have when it is refined.
  /// Throws std::invalid_argument if there is no edge between the ends of one of these.
  template <typename LevelType>
  void FollowToPart(const LevelType& part, const Buffer<Id>& vertices, std::size_t level);

private:
  void FindLevels();
  void FindAncestors();
  const std::array<Id, 2>& GetEnds(Id midpoint) const
  {
    return this->Midpoints[static_cast<std::size_t>(midpoint - this->First)];
  }

  const Id First;
  const std::vector<std::array<Id, 2>>& Midpoints;
  std::vector<int> Levels;                ///< on which vertices first exist
  std::vector<std::vector<Id>> Born;      ///< vertices by level
  std::vector<std::vector<Id>> Wanted;    ///< those of them that are wanted
  std::vector<std::vector<Id>> Ancestors; ///< by level
  std::vector<Id> At; ///< number on the current part of each ancestor and newest vertex
};

}

#endif
