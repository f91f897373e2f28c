// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceFrames.h
 * Normals and tangents of the limit surface as point arrays.
 */
#ifndef SubdivisionObjects_SurfaceFrames_h
#define SubdivisionObjects_SurfaceFrames_h

#include "Core/Operators/ShadingNormals.h"
#include "Core/Operators/TangentErrors.h"
#include "Core/Surfaces/Steps/SurfaceSteps.h"
#include "Private/ArrayNames.h"

#include <functional>

class vtkDataArray;
class vtkPolyData;

namespace subdivision
{

/// The turned faces (FindTurnedFaces) of the last level from those of the first: children have the
/// orientation of their parents.
template <typename Id>
Buffer<unsigned char> SpreadTurned(const SurfaceSteps<Id>& steps, Buffer<unsigned char>&& turned);

/// The tangents at the limits of the vertices of the last level, whose faces are `turned`.
/// `points`: the vertices before they are moved to the limit, float or double.
template <typename Id>
TangentPairs FindLimitTangents(
  const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& turned, vtkDataArray* points);

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

/// Adds the arrays of normals and tangents to the output. `points`: where the vertices are in the
/// end. `sources`: the vertex whose normal and tangents each output point takes; empty: its own.
/// `addCells` adds the cells from which normals for shading are made.
void AddLimitFrames(const TangentPairs& tangents, vtkDataArray* points,
  const Buffer<vtkIdType>& sources, bool normals, bool twoTangents,
  const std::function<void(ShadingNormals&)>& addCells, vtkPolyData* input, vtkPolyData* output);

/// Puts these arrays behind those of the input, once the output has these.
void MoveLimitFramesToEnd(vtkPolyData* output);

/// Adds the faces and lines of a level; all other vertices count as single points. `turned`: as
/// of FindTurnedFaces.
template <typename Id>
void AddShadingCells(
  const SurfaceLevel<Id>& level, const Buffer<unsigned char>& turned, ShadingNormals& normals);

}

#endif
