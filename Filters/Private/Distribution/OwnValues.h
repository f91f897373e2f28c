// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OwnValues.h
 * Values that parts of a joined mesh have for the same point, each its own, as values that jump
 * (Private/Values/MaterialFields.h) need them.
 */
#ifndef SubdivisionObjects_OwnValues_h
#define SubdivisionObjects_OwnValues_h

#include "Private/Distribution/JoinedMesh.h"

#include <vector>

namespace subdivision
{

/// Which parts keep their own values.
enum class OwnValues
{
  OfAll,
  OfBlocks ///< parts with MeshPart::KeepsOwnFloats; the cell array OwnBlockName tells of them
};

/**
 * Gives the mesh a copy of each point for which a part has another value than the mesh, in an array
 * of floating point numbers. Copies follow after all points, the cells of that part have them, and
 * the point array MaterialPointIds says which point each is. PointIds and PointPlaces stay as in
 * the mesh without copies.
 */
void KeepOwnValues(
  const std::vector<MeshPart>& parts, JoinedMesh& joined, OwnValues keeps = OwnValues::OfAll);

/// Gives copies of points, of which MaterialPointIds tells, the numbers of these points; an earlier
/// filter gave the numbers.
void TakeCopiedPoints(std::vector<MeshPart>& parts);

}

#endif
