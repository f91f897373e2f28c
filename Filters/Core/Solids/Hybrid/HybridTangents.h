// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridTangents.h
 * Tangents and normals at the limit of surfaces of triangles and quads, and of the outsides of
 * solids (Mathematics 8, 15).
 *
 * Faces around a vertex, or in a sector along a curve, have the tangents of the triangles or quads
 * alone where they are of one type (LimitNormals.h, SectorMasks.h). Where both meet, tangents are
 * left eigenvectors of the matrix of the fan for the two largest eigenvalues below 1, which powers
 * of it find. A sector has a tangent plane only if the tangent along the curve is one of them.
 */
#ifndef SubdivisionObjects_HybridTangents_h
#define SubdivisionObjects_HybridTangents_h

#include "Core/Operators/FaceSides.h"
#include "Core/Solids/Hybrid/HybridFans.h"
#include "Core/Solids/Limits/LimitNormals.h"

#include <vector>

namespace subdivision
{

/// The weights of two tangents of a fan, by its items; none: it has no tangent plane.
struct FanTangents
{
  std::vector<double> First;
  std::vector<double> Second;
};
/// `key`: HybridFan::GetKey. `modified`: by the rules of ModifiedBoundary.
FanTangents FindFanTangents(const Neighbourhood& key, LoopWeights weights, bool modified);

/// The tangents at all vertices of a level. `controls`: the control cell of each cell. Their
/// numbers stand for those of tetrahedra and triangles in LimitTangents.
template <typename Id>
LimitTangents<Id> BuildHybridTangents(
  const HybridLevel<Id>& level, const std::vector<vtkIdType>& controls, int steps);

/// The sides of the faces of a control level, by cells, as FindTriangleSides.
template <typename Id>
FaceSides FindPolygonSides(const HybridLevel<Id>& level);

}

#endif
