// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceFrames.h
 * Normals and tangents of the limit surface as point arrays.
 */
#ifndef SubdivisionObjects_SurfaceFrames_h
#define SubdivisionObjects_SurfaceFrames_h

#include "Core/SurfaceSteps.h"
#include "Core/TangentErrors.h"

class vtkDataArray;
class vtkPolyData;

namespace subdivision
{

constexpr const char* LimitNormalsName = "LimitNormals";
constexpr const char* LimitTangentNames[2] = { "LimitTangent1", "LimitTangent2" };

/// From the tangents of each point, of a mesh with points of `type`.
void AddLimitFrames(const TangentPairs& tangents, int type, const Buffer<vtkIdType>& sources,
  bool normals, bool twoTangents, vtkPolyData* input, vtkPolyData* output);

/// `points`: of the last level, float or double. `sources`: whose frame each output point takes;
/// empty: its own.
template <typename Id>
void AddLimitFrames(const SurfaceSteps<Id>& steps, vtkDataArray* points,
  const Buffer<vtkIdType>& sources, bool normals, bool twoTangents, vtkPolyData* input,
  vtkPolyData* output);

}

#endif
