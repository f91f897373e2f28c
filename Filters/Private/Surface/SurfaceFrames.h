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

/// The tangents at the limits of the vertices of the last level. `points`: the vertices before they
/// are moved to the limit, float or double.
template <typename Id>
TangentPairs FindLimitTangents(const SurfaceSteps<Id>& steps, vtkDataArray* points);

/// Adds the arrays of normals and tangents to the output. `points`: where the vertices are in the
/// end. `sources`: the vertex whose normal and tangents each output point takes; empty: its own.
/// `addCells` adds the cells from which normals for shading are made.
void AddLimitFrames(const TangentPairs& tangents, vtkDataArray* points,
  const Buffer<vtkIdType>& sources, bool normals, bool twoTangents,
  const std::function<void(ShadingNormals&)>& addCells, vtkPolyData* input, vtkPolyData* output);

/// Adds the faces and lines of a level; all other vertices count as single points.
template <typename Id>
void AddShadingCells(const SurfaceLevel<Id>& level, ShadingNormals& normals);

}

#endif
