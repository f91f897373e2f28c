// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceTags.h
 * Which rule the vertices and edges of an input surface follow (Mathematics 4, 6, 12).
 */
#ifndef SubdivisionObjects_SurfaceTags_h
#define SubdivisionObjects_SurfaceTags_h

#include "Core/Memory/Coordinates.h"
#include "Core/Rules/Rule.h"
#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <vector>

namespace subdivision
{

struct SurfaceFeatures
{
  /// 1 for each edge that is a crease and each vertex that is a corner; may be empty.
  std::vector<unsigned char> SharpEdges;
  std::vector<unsigned char> Corners;
  /// For each vertex the angle alpha in radians, which counts only if the vertex has exactly one
  /// sector, and the flatness s. Where a value is negative or NaN the mesh decides. May be empty.
  std::vector<double> Angles;
  std::vector<double> Flatness;
  /// The angle of each corner of a face, negative: from the mesh. May be empty.
  std::vector<double> FaceAngles;
  bool DartEnds = false;
  /// Blend or Sharp. Schemes without rules for joints take Sharp.
  JointRule Type1 = JointRule::Blend;
  JointRule Type2 = JointRule::Blend;
  JointRule Type3 = JointRule::Blend;
};

/// The angle of a face at one of its corners, in radians.
template <typename Id>
double MeasureFaceAngle(const PolygonMesh<Id>& mesh, Id corner, const double* points);

/// `points`: of each vertex; the angles of corners are measured there.
template <typename Id>
SurfaceTags<Id> ClassifySurface(const PolygonMesh<Id>& mesh, const SurfaceScheme<Id>& scheme,
  const SurfaceFeatures& features, const Coordinates& points);

}

#endif
