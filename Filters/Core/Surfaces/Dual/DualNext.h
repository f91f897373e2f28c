// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DualNext.h
 * Steps of dual schemes from a level that is not made (SkippedLevel.h): what they share.
 */
#ifndef SubdivisionObjects_DualNext_h
#define SubdivisionObjects_DualNext_h

#include "Core/Surfaces/Dual/DualPlaces.h"

namespace subdivision
{

/// Whether each vertex has one fan, which is a cycle of three or more faces, all faces are oriented
/// alike, and there are no lines and vertex cells. Then a step makes one face at each vertex, all
/// vertices of the next level have four faces, and what lies around them follows by arithmetic.
template <typename Id>
bool IsClosedDual(const SurfaceLevel<Id>& level);

/// The counts of the level after one that was skipped, and so has only its counts: it has
/// `vertices` vertices, and the faces inside those of the skipped one come first, then `quads`,
/// whose offsets are not stored (PolygonMesh::GetFirstOfCounted).
template <typename Id>
SurfaceLevel<Id> CountDual(const SurfaceLevel<Id>& skipped, vtkIdType vertices, vtkIdType quads);

}

#endif
