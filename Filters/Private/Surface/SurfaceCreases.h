// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceCreases.h
 * Creases and corners of a surface as the user wants them: cell arrays and options as values of the
 * control mesh.
 */
#ifndef SubdivisionObjects_SurfaceCreases_h
#define SubdivisionObjects_SurfaceCreases_h

#include "Core/Surfaces/Scheme/SurfaceTags.h"
#include "Private/Run/Features.h"
#include "Private/Surface/SurfaceCells.h"
#include "Private/Surface/SurfaceStamp.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace subdivision
{

struct SurfaceCreases
{
  SurfaceFeatures Features;
  EdgeSharpness Sharpness; ///< of each edge; empty where there is none
};

/// The rule for joints that surfaces have instead of one that they do not know.
JointRule FindKnownRule(JointRule rule);

/// Reads the cell arrays; `level` was made from `cells`.
template <typename Id>
SurfaceCreases ReadSurfaceCreases(
  const FeatureOptions& options, const SurfaceCells& cells, const SurfaceLevel<Id>& level);

/// Creases with a finite sharpness end after some levels, and then there are other corners.
/// WriteSharpCorners puts their data of the control mesh into the stamp: measured angles of faces,
/// and angles and flatness that the user gave. ReadSharpCorners takes them from there in the next
/// filter.
template <typename Id>
void WriteSharpCorners(const PolygonMesh<Id>& mesh, const SurfaceCreases& creases,
  const double* points, SurfaceStamp& stamp);
template <typename Id>
void ReadSharpCorners(
  const SurfaceStamp& stamp, const PolygonMesh<Id>& mesh, SurfaceFeatures& features);

/// Takes angles and flatness that were given to an earlier filter from the stamp of a part.
void TakeGivenOfPart(const SurfaceStamp& stamp, SurfaceFeatures& features);

/// The values of the first `points` points, times a factor; -1 for a negative value. Empty without
/// an array.
std::vector<double> ReadPointValues(vtkDataArray* array, vtkIdType points, double factor);

/// As pairs of points: with PreserveInterfaces the edges between exactly two faces, of different
/// materials; with DetectFeatures the edges at which the surface turns by more than FeatureAngle.
/// `faceCells` has the cell of each face.
template <typename Id>
std::vector<vtkIdType> FindDerivedEdges(const PolygonMesh<Id>& mesh,
  const std::vector<vtkIdType>& faceCells, const Coordinates& points,
  const FeatureOptions& options);
/// The edges that marks make sharp, also around marked faces, and the corners.
SharpPairs FindMarkedEdges(vtkPolyData* input, const MarkOptions& marks,
  const std::function<void(const std::string&)>& warn);
/// Makes edges sharp that are given as pairs of points; a point twice makes this point a corner.
template <typename Id>
void AddSharpEdges(const PolygonMesh<Id>& mesh, const SharpPairs& pairs, SurfaceCreases& creases);
/// All sharp edges and corners as such pairs.
template <typename Id>
std::vector<vtkIdType> ListSharpEdges(const PolygonMesh<Id>& mesh, const SurfaceFeatures& features);

}

#endif
