// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceCreases.h
 * What the user says of creases and corners of a surface: cell arrays and options as values of the
 * control mesh.
 */
#ifndef SubdivisionObjects_SurfaceCreases_h
#define SubdivisionObjects_SurfaceCreases_h

#include "Core/Surfaces/Scheme/SurfaceTags.h"
#include "Private/Control/Features.h"
#include "Private/Surface/SurfaceCells.h"
#include "Private/Surface/SurfaceStamp.h"

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

/// What is measured and given of the corners at creases that are sharp for some levels, from a
/// control mesh to the stamp, and back in a filter that goes on from there.
template <typename Id>
void WriteSharpCorners(const PolygonMesh<Id>& mesh, const SurfaceCreases& creases,
  const double* points, SurfaceStamp& stamp);
template <typename Id>
void ReadSharpCorners(
  const SurfaceStamp& stamp, const PolygonMesh<Id>& mesh, SurfaceFeatures& features);

/// A value for each of the first points of an array, times a factor; -1 where there is none. No
/// array: no values.
std::vector<double> ReadPointValues(vtkDataArray* array, vtkIdType points, double factor);

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
