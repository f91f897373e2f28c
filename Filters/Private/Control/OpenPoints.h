// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpenPoints.h
 * Warns where cells have points of their own at one place: they come apart there, although most
 * users meant them to be joined.
 */
#ifndef SubdivisionObjects_OpenPoints_h
#define SubdivisionObjects_OpenPoints_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <string>

namespace subdivision
{

/**
 * A warning that counts points with equal coordinates, names two of them, and tells what helps.
 * Empty if no cells would be joined if they shared these points: parts that touch at a point only,
 * and cells without a size, are no reason to warn.
 *
 * Only open parts of the border can be joined: faces of one tetrahedron, edges of one triangle,
 * ends of lines; beside tetrahedra, all triangles and lines that are no part of them. Others, most
 * of a solid, need no search. Takes a step for each face or edge, and a few for each open point,
 * whose coordinates are hashed; 16 to 32 bytes for each of these.
 */
template <typename Id>
std::string DescribeCoincident(
  const SimplicialComplex<Id>& complex, const Coordinates& coordinates);
template <typename Id>
std::string DescribeCoincidentOfSurface(
  const PolygonMesh<Id>& mesh, const Coordinates& coordinates);

}

#endif
