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

constexpr const char* LimitTangentNames[2] = { "LimitTangent1", "LimitTangent2" };

/// The tangents at the points of the last level, which are float or double, before they go to the
/// limit.
template <typename Id>
TangentPairs FindLimitTangents(const SurfaceSteps<Id>& steps, vtkDataArray* points);

/// Adds the arrays. `points`: where they are in the end; `sources`: whose frame each output point
/// takes; empty: its own; `addCells` adds the cells there to normals for shading.
void AddLimitFrames(const TangentPairs& tangents, vtkDataArray* points,
  const Buffer<vtkIdType>& sources, bool normals, bool twoTangents,
  const std::function<void(ShadingNormals&)>& addCells, vtkPolyData* input, vtkPolyData* output);

/// The faces and lines of a level; all other points are single.
template <typename Id>
void AddShadingCells(const SurfaceLevel<Id>& level, ShadingNormals& normals);

}

#endif
