// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KeptParts.h
 * The knowledge of a mesh of several ranks that a filter keeps, so that new values on the same
 * cells cost one exchange of values.
 */
#ifndef SubdivisionObjects_KeptParts_h
#define SubdivisionObjects_KeptParts_h

#include "Private/Distribution/Layers.h"

#include <cstdint>
#include <string>

namespace subdivision
{

/// Of one partition.
class KeptPartition
{
public:
  /// If cells, ids, and which arrays there are, are the same on all ranks as they were: gives the
  /// parts the numbers of before (IdentifyPoints, TakeStampedNumbers), adds the parts that came
  /// from others (AddLayers, ShareArrays), with their values of now, and returns true. `layers`:
  /// how many are wanted. `joinsCopies`: as in IdentifyPoints. All partitions call it.
  bool Restore(std::vector<MeshPart>& parts, int layers, bool joinsCopies, Exchange& exchange);

  /// Keeps the knowledge gained since Restore returned false. `haveSeveralPlaces`: of
  /// IdentifyPoints.
  void Keep(const std::vector<MeshPart>& parts, SentLayers sent, bool areStamped,
    bool haveSeveralPlaces, std::vector<std::string> warnings);
  void Forget();

  const SentLayers& GetSent() const { return this->Sent; }
  bool AreStamped() const { return this->Stamped; }
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

private:
  using Key = std::vector<std::uint64_t>;

  Key Current;       ///< as Restore found it
  Key CurrentPlaces; ///< of points with global ids
  Key Known;         ///< as it was kept; empty: nothing
  Key KnownPlaces;
  std::vector<MeshPart> Parts; ///< without values
  SentLayers Sent;
  bool Stamped = false;
  bool HasSeveralPlaces = false;
  std::vector<std::string> Warnings;
};

/// Of the partitions of a rank, of which a filter has one.
class KeptParts
{
public:
  std::vector<KeptPartition> OfPartitions;
};

}

#endif
