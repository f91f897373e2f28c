// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointIds.h
 * Says which points of several meshes are one point.
 */
#ifndef SubdivisionObjects_PointIds_h
#define SubdivisionObjects_PointIds_h

#include "Private/Distribution/JoinedMesh.h"
#include "Private/Partitions/OtherPartitions.h"

#include <functional>
#include <string>

namespace subdivision
{

/**
 * Sets Points and Cells of the parts of a partition, which all partitions do together.
 *
 * Points of the same global id and place (FindPlacesOfIds) are one point. If a part has no global
 * ids, points of the same coordinates are, bit for bit (-0 is 0); where one part has two points at
 * a place, these and all others there stay apart, and `warn` gets a message. Blocks that are other
 * cases of a mesh (FindCases) share no points with it. Points that only duplicate (ghost) cells use
 * get -1, as these cells do. Cells are ordered by global ids if all parts have them, each one once;
 * else by partition, part and index. The numbers that are made here start at 0 and have no gaps.
 *
 * With `joinsCopies` points of a part that are copies (Private/Values/PointCopies.h) are one
 * point.
 *
 * Returns whether some points of one id lie at different places.
 *
 * Without global ids of points four exchanges, at most 72 bytes for each point; with global ids of
 * cells one, 8 bytes for each cell.
 */
bool IdentifyPoints(std::vector<MeshPart>& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn, bool joinsCopies = false);

}

#endif
