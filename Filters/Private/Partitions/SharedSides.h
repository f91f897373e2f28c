// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedSides.h
 * The upper side of each part of a surface (FaceSides.h) of which several partitions have faces.
 */
#ifndef SubdivisionObjects_SharedSides_h
#define SubdivisionObjects_SharedSides_h

#include "Core/Operators/FaceSides.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedDirectory.h"
#include "Private/Reading/CellsToSimplices.h"

#include <vector>

namespace subdivision
{

/// Vertices whose cells are all known: vertices of own cells. Empty: all are, as there are no
/// others.
std::vector<char> FindSureVertices(const SimplicesOfCells& cells, const OtherPartitions* others);

/**
 * Which faces are turned, from the sides that this partition finds; empty if no partition has faces
 * that are oriented differently. `faces`: their keys, of which the first face of a part has the
 * smallest; faces with a negative key have no own face near them. Links have to be right in the
 * whole, and each has to be known to a partition.
 *
 * All partitions call this together. A directory finds where parts of two partitions share a face;
 * the first partition joins them. This takes four exchanges, 8 (Width + 2) bytes for each face, and
 * about 50 for each two parts that share any; where all are oriented alike, one sum.
 */
Buffer<unsigned char> JoinSides(
  const FaceSides& sides, const SharedKeys& faces, OtherPartitions& others);

}

#endif
