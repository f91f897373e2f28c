// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedSplits.h
 * Red-green refinement of a mesh of which several partitions have parts.
 */
#ifndef SubdivisionObjects_SharedSplits_h
#define SubdivisionObjects_SharedSplits_h

#include "Core/Solids/RedGreen/RedGreen.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/RedGreen/RedGreenMesh.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace subdivision
{

/// The part of each simplex in the state of a partition: own cells count, cells that share a point
/// with them are split too, so that errors at own edges have all their triangles, all others stay.
std::vector<CellScope> FindScopes(const RedGreenMesh& mesh, const OtherPartitions& others);

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
  SharedSplits(const RedGreenMesh& mesh, OtherPartitions& others);

  /// Ends a round of the state, as RedGreen::Close does.
  void Close(RedGreen<Id>& state);

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

  static Name Mix(const Name& a, const Name& b);
  void NameCentres();
  Name GetName(Id vertex) const;
  Id Find(const Name& name) const;
  void NameNew(const RedGreen<Id>& state);
  using Splits = Exchange::Lists<Split>;
  Splits TakeNew(const RedGreen<Id>& state);
  void Receive(const Splits& splits, RedGreen<Id>& state);

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
