// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockCases.h
 * Which blocks are not parts of one object, although they share points or ids of points.
 */
#ifndef SubdivisionObjects_BlockCases_h
#define SubdivisionObjects_BlockCases_h

#include "Private/Distribution/JoinedMesh.h"
#include "Private/Partitions/OtherPartitions.h"

#include <functional>
#include <string>

namespace subdivision
{

/**
 * Sets MeshPart::Case. Two blocks with cells between the same points are cases (or time steps) of
 * one mesh if these are half of the cells of one of them or more, or if values at their points
 * differ: blocks that such pairs connect, also by way of others, are numbered from 0 in the order
 * of blocks. Blocks of the same case are joined. Only cells of the highest dimension that there is
 * count, so that sets of faces remain parts of the solids. A block without cells is a case of its
 * own. Points have numbers (MeshPart::Points). Returns whether there are several cases; `warn` then
 * gets a message. Linear in the number of blocks and cells, up to sorting; two exchanges.
 */
bool FindCases(std::vector<MeshPart>& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn);

/// Whether the parts are of several blocks.
bool AreSeveralBlocks(const std::vector<MeshPart>& parts, Exchange& exchange);

/**
 * Sets MeshPart::KeepsOwn and KeepsOwnFloats of all parts of the blocks that have other values than
 * another block at a point which they share, whichever partition sees that; and gives a warning.
 * The numbers of floating point arrays are the same where they differ by rounding only: by 1e-12,
 * or in single precision 2.5e-7 of them; one that is none is like another. Returns whether floating
 * point numbers of some blocks differ.
 */
bool FindOwnBlocks(std::vector<MeshPart>& parts, Exchange& exchange,
  const std::function<void(const std::string&)>& warn);

}

#endif
