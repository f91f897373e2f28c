// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceCreases.h
 * What the user says of creases and corners of a surface: cell arrays and options as values of the
 * control mesh.
 */
#ifndef SubdivisionObjects_SurfaceCreases_h
#define SubdivisionObjects_SurfaceCreases_h

#include "Core/SurfaceTags.h"
#include "Features.h"
#include "SurfaceCells.h"

namespace subdivision
{

struct SurfaceCreases
{
  SurfaceFeatures Features;
  EdgeSharpness Sharpness; ///< of each edge; empty where there is none
};

/// What the arrays say; `level` was made from `cells`.
template <typename Id>
SurfaceCreases ReadSurfaceCreases(
  const FeatureOptions& options, const SurfaceCells& cells, const SurfaceLevel<Id>& level);

/// Edges where the surface turns by more than an angle in degrees, as pairs of points; and back. A
/// pair of one point is a corner. All sharp edges and corners as such pairs.
template <typename Id>
std::vector<vtkIdType> FindFeatureEdges(
  const PolygonMesh<Id>& mesh, const Coordinates& points, double angle);
template <typename Id>
void AddSharpEdges(
  const PolygonMesh<Id>& mesh, const std::vector<vtkIdType>& pairs, SurfaceFeatures& features);
template <typename Id>
std::vector<vtkIdType> ListSharpEdges(const PolygonMesh<Id>& mesh, const SurfaceFeatures& features);

}

#endif
