// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceFrames.h
 * Normals and tangents of the limit surface as point arrays.
 */
#ifndef SubdivisionObjects_SurfaceFrames_h
#define SubdivisionObjects_SurfaceFrames_h

#include "Core/Operators/TangentErrors.h"
#include "Core/Surfaces/Scheme/SurfaceLimits.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

namespace subdivision
{

/// The turned faces (FindTurnedFaces) of the last level from the ones of the first: children have
/// the orientation of their parents.
template <typename Id>
Buffer<unsigned char> SpreadTurned(const SurfaceSteps<Id>& steps, Buffer<unsigned char>&& turned);

/// Normals in the type of the points, and two tangents for each vertex; each only if somebody wants
/// it.
struct LimitFrames
{
  vtkSmartPointer<vtkDataArray> Normals;
  Buffer<double> Tangents[2];
};

/// These at the limits of the vertices of the last level, whose faces are `turned`. `points`: the
/// vertices before they are moved to the limit, float or double.
template <typename Id>
LimitFrames FindLimitFrames(const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& turned,
  vtkDataArray* points, bool normals, bool tangents);

/// The sides of what is sharp: a side is a sector whose normal in the limit is known.
struct SharpSides
{
  Buffer<vtkIdType> OfCorners; ///< the side of each corner of a face; -1: its vertex has no other
  std::vector<double> Normals; ///< three numbers for each side
};

/// The sides of a last level. `points`: its vertices before they go to the limit.
template <typename Id>
SharpSides FindSharpSides(const SurfaceLevel<Id>& level, LimitFinder<Id>& finder,
  const Buffer<unsigned char>& turned, vtkDataArray* points);

/// Gives the output, whose polygons are the faces, a point for each side.
template <typename Id>
void SplitSides(const SharpSides& sides, const PolygonMesh<Id>& mesh, vtkPolyData* output);

/// Turns the second tangent of each vertex whose face, `faceOf(vertex)` or -1, is turned over, so
/// that normals have one side in each part; `turned`: as of FindTurnedFaces.
template <typename FaceOf>
void TurnTangents(const Buffer<unsigned char>& turned, const FaceOf& faceOf, TangentPairs& tangents)
{
  ForEach(turned.empty() ? 0 : tangents.Errors.size(),
    [&](vtkIdType v)
    {
      const vtkIdType face = faceOf(v);
      for (vtkIdType i = 3 * v; i < 3 * v + 3 && face >= 0 && turned[face]; ++i)
      {
        tangents.Values[1][i] = -tangents.Values[1][i];
      }
    });
}

/// Sets the normals of tangents: at vertices of a level, of which they may be missing
/// (FindShadingNormals), and at further points.
template <typename Id>
void FindNormals(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const Buffer<unsigned char>& turned, const double* points,
  TangentPairs& tangents);

}

#endif
