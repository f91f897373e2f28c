// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlacesOfIds.h
 * Whether points of the same id lie at the same place.
 */
#ifndef SubdivisionObjects_PlacesOfIds_h
#define SubdivisionObjects_PlacesOfIds_h

#include "Private/Distribution/JoinedMesh.h"
#include "Private/Partitions/OtherPartitions.h"

#include <functional>
#include <string>

namespace subdivision
{

/**
 * Compares the places of points that have the same id (MeshPart::Points; -1 is left out). Places
 * are the same up to a millionth of the size of the larger part. Returns whether the places of an
 * id differ; `warn` gets a message, and MeshPart::Variants then tells the points of an id apart: 0
 * for points at the place of the first one, other numbers for other places.
 *
 * One exchange, of 48 bytes for each point, and one more of 8 where places differ.
 */
bool FindPlacesOfIds(std::vector<MeshPart>& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn);

/// Whether the points of each id lie at one place, by the same rule, among the parts that a
/// partition has, with the parts of others. All partitions call it, and get the same answer;
/// nothing else is sent.
bool HavePlacesOfIds(std::vector<MeshPart>& parts, Exchange& exchange);

}

#endif
