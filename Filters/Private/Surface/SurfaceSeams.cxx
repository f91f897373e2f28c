// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceSeams.h"

#include "Core/Memory/Ids.h"
#include "Private/Reading/NearPoints.h"

#include <numeric>

namespace subdivision
{

bool JoinEqualPoints(const SurfaceCells& cells, const double* points, JoinedSurface& joined)
{
  std::vector<vtkIdType> all(static_cast<std::size_t>(cells.NumberOfPoints));
  std::iota(all.begin(), all.end(), vtkIdType(0));
  const Buffer<vtkIdType> found = FindFirstOfNear(points, all, 0., PointOrder{});
  joined.FirstPoints.assign(found.begin(), found.end());
  std::vector<vtkIdType>& firsts = joined.FirstPoints;
  // Points of one face stay apart, so that it keeps its corners.
  auto separate = [&firsts](const vtkIdType* ids, vtkIdType size)
  {
    for (const vtkIdType i : InTurn(size))
    {
      for (vtkIdType j = 0; j < i; ++j)
      {
        if (firsts[ids[i]] == firsts[ids[j]])
        {
          firsts[ids[i]] = ids[i];
          firsts[ids[j]] = ids[j];
        }
      }
    }
  };
  for (const vtkIdType f : InTurn(cells.GetNumberOfFaces()))
  {
    separate(
      cells.Corners.data() + cells.FaceOffsets[f], cells.FaceOffsets[f + 1] - cells.FaceOffsets[f]);
  }
  for (const std::size_t s : InTurn(cells.SegmentCells.size()))
  {
    separate(cells.Segments.data() + 2 * s, 2);
  }
  joined.Cells = cells;
  for (auto* ids : { &joined.Cells.Corners, &joined.Cells.Segments, &joined.Cells.Vertices })
  {
    for (vtkIdType& id : InTurn(*ids))
    {
      id = firsts[id];
    }
  }
  return joined.Cells.Corners != cells.Corners || joined.Cells.Segments != cells.Segments;
}

template <typename Id>
void AddSeamCorners(const PolygonMesh<Id>& mesh, const JoinedSurface& joined,
  const SurfaceTags<Id>& tags, SurfaceFeatures& features)
{
  std::vector<int> copies(joined.FirstPoints.size(), 0);
  for (vtkIdType first : joined.FirstPoints)
  {
    ++copies[first];
  }
  features.Corners.resize(mesh.NumberOfVertices, 0);
  for (const vtkIdType v : InTurn(mesh.NumberOfVertices))
  {
    const Id corner = mesh.VertexCorners[v];
    const bool isInside = corner >= 0 && VisitFan(mesh, corner, [](const FanStep<Id>&) {});
    const vtkIdType first = joined.FirstPoints[v];
    const bool wasSmooth = tags.Vertices[first] == VertexTag::Smooth;
    const bool goesThrough = wasSmooth ? copies[first] == 2 : copies[first] == 1;
    features.Corners[v] |= corner != -1 && !isInside && !goesThrough;
  }
}

template <typename Id>
Buffer<vtkIdType> FindJoinedVertices(
  const SurfaceSteps<Id>& steps, const SurfaceSteps<Id>& joinedSteps, vtkIdType numberOfPoints)
{
  const int last = steps.GetNumberOfSteps();
  const SurfaceLevel<Id>& level = steps.GetLevel(last);
  const SurfaceLevel<Id>& joined = joinedSteps.GetLevel(last);
  Buffer<vtkIdType> vertices(level.Mesh.NumberOfVertices, 0);
  // Control points keep their ids, and both meshes split their cells in the same order.
  std::iota(vertices.begin(), vertices.begin() + numberOfPoints, vtkIdType(0));
  for (const vtkIdType i : InTurn(2 * level.Lines.size()))
  {
    auto end = [i](const SurfaceLevel<Id>& of)
    {
      const Id line = of.Lines[i / 2];
      return of.Mesh.EdgeVertices[2 * (line / 2) + (line % 2 + i % 2) % 2];
    };
    vertices[end(level)] = end(joined);
  }
  Buffer<vtkIdType> corners(steps.GetNumberOfCorners(last));
  Buffer<vtkIdType> joinedCorners(corners.size());
  steps.WriteFaces(last, corners.data());
  joinedSteps.WriteFaces(last, joinedCorners.data());
  for (const vtkIdType c : InTurn(corners.size()))
  {
    vertices[corners[c]] = joinedCorners[c];
  }
  return vertices;
}

SUBDIVISION_COMPILE_FUNCTION(AddSeamCorners);
SUBDIVISION_COMPILE_FUNCTION(FindJoinedVertices);

}
