// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSeams.h
 * Seams of texture coordinates: curves along which points exist several times, once for each side.
 * Coordinates, normals and tangents follow the mesh in which equal points are joined, all else the
 * mesh as it is.
 */
#ifndef SubdivisionObjects_SurfaceSeams_h
#define SubdivisionObjects_SurfaceSeams_h

#include "Core/Surfaces/Scheme/SurfaceTags.h"
#include "Private/Surface/SurfaceCells.h"

namespace subdivision
{

struct JoinedSurface
{
  std::vector<vtkIdType> FirstPoints; ///< the first of the points that each is joined with
  SurfaceCells Cells;
};

/// Joins points of equal coordinates, but not of one face or segment. False if no cell changes.
bool JoinEqualPoints(const SurfaceCells& cells, const double* points, JoinedSurface& joined);

/// Where a seam ends, meets others, or a boundary or crease, it has a corner on each side. `mesh`:
/// with seams; `tags`: of the joined mesh.
template <typename Id>
void AddSeamCorners(const PolygonMesh<Id>& mesh, const JoinedSurface& joined,
  const SurfaceTags<Id>& tags, SurfaceFeatures& features);

/// For each vertex of the last level with seams the vertex of the last joined level that it is; the
/// control points are the first `numberOfPoints`.
template <typename Id>
Buffer<vtkIdType> FindJoinedVertices(
  const SurfaceSteps<Id>& steps, const SurfaceSteps<Id>& joined, vtkIdType numberOfPoints);

}

#endif
