// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Dual/DualNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

namespace subdivision
{

template <typename Id>
bool IsClosedDual(const SurfaceLevel<Id>& level)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const DualPlaces<Id>& places = *level.Dual;
  if (places.GetNumberOfChains() > 0 || places.GetNumberOfLoneRows() > 0)
  {
    return false;
  }
  return AreAll(mesh.NumberOfVertices + 1, [&](vtkIdType v) { return places.Faces[v] == v; }) &&
    AreAll(mesh.GetNumberOfCorners(),
      [&](vtkIdType c) { return mesh.Vertices[mesh.Twins[c]] != mesh.Vertices[c]; });
}

template <typename Id>
SurfaceLevel<Id> CountDual(const SurfaceLevel<Id>& skipped, vtkIdType vertices, vtkIdType quads)
{
  const Buffer<Id>& before = skipped.Mesh.FaceOffsets;
  SurfaceLevel<Id> next;
  next.Step = skipped.Step + 1;
  next.Mesh.NumberOfVertices = vertices;
  next.Mesh.NumberOfFaces = skipped.Mesh.NumberOfFaces + quads;
  vtkIdType stored = before.size() - 1;
  while (stored > 0 && before[stored] - before[stored - 1] == 4)
  {
    --stored;
  }
  next.Mesh.FaceOffsets = Buffer<Id>(stored + 1);
  CopyInThreads(before.data(), stored + 1, next.Mesh.FaceOffsets.data());
  return next;
}

SUBDIVISION_COMPILE_FUNCTION(IsClosedDual);
SUBDIVISION_COMPILE_FUNCTION(CountDual);

}
