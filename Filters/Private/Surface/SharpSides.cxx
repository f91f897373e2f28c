// SPDX-License-Identifier: BSD-3-Clause
// A point and a normal for each side of what is sharp (SurfaceFrames.h).
#include "Private/Surface/SurfaceFrames.h"

#include "Core/Memory/Ids.h"
#include "Private/ArrayNames.h"
#include "Private/Values/PointCopies.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace subdivision
{
namespace
{

/// The normal of the limit in a sector at a corner, or at a curve along all that is sharp there.
template <typename Id>
bool FindNormalOfSector(const SurfaceLevel<Id>& level, LimitFinder<Id>& finder, Id corner,
  const double* points, double normal[3])
{
  const Id vertex = level.Mesh.Vertices[corner];
  const VertexTag tag = level.Tags.Vertices[vertex];
  std::vector<Id> sharp;
  CollectSharpEdges(level.Mesh, level.Tags, vertex, sharp);
  if (tag != VertexTag::Corner && (tag != VertexTag::Curve || sharp.size() != 2))
  {
    return false;
  }
  double tangents[2][3];
  double error = 0.;
  RowBlock<Id> row;
  for (const LimitKind kind : { LimitKind::Tangent1, LimitKind::Tangent2 })
  {
    row.Clear();
    finder.AppendOfSector(corner, kind, row);
    row.Apply(points, tangents[kind == LimitKind::Tangent2], 3);
    error += GetTangentError(row, 0, points, DoubleUnit);
  }
  return FindClearNormal(tangents[0], tangents[1], error, normal);
}

}

template <typename Id>
SharpSides FindSharpSides(const SurfaceLevel<Id>& level, LimitFinder<Id>& finder,
  const Buffer<unsigned char>& turned, vtkDataArray* points)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  SharpSides sides{ Buffer<vtkIdType>(mesh.Vertices.size(), -1), {} };
  Buffer<double> converted;
  const double* x = ReadDoubles(
    points->GetVoidPointer(0), points->GetDataType(), points->GetNumberOfValues(), converted);
  std::vector<Id> corners;
  ForEachInTurn(mesh.NumberOfVertices,
    [&](vtkIdType v)
    {
      const auto before = sides.Normals.size();
      corners.clear();
      if (level.Tags.Vertices[v] != VertexTag::Smooth)
      {
        VisitFans(mesh, static_cast<Id>(v),
          [&](Id corner)
          {
            VisitFan(
              mesh, corner, [&](const FanStep<Id>& step) { corners.push_back(step.Corner); });
          });
      }
      bool areKnown = true;
      for (const Id corner : corners)
      {
        const SectorEnds<Id> ends = FindSectorEnds(mesh, level.Tags, corner);
        double normal[3];
        if (sides.OfCorners[corner] >= 0 || !areKnown)
        {
          continue;
        }
        areKnown = ends.Size > 0 && FindNormalOfSector(level, finder, corner, x, normal);
        FanStep<Id> step = ends.First;
        for (int i = 0; i < ends.Size; ++i, step.Advance(mesh))
        {
          sides.OfCorners[step.Corner] = static_cast<vtkIdType>(sides.Normals.size() / 3);
        }
        const bool isTurned = !turned.empty() && turned[mesh.GetFace(ends.First.Corner)];
        for (int c = 0; c < 3 && areKnown; ++c)
        {
          sides.Normals.push_back(isTurned ? -normal[c] : normal[c]);
        }
      }
      if (!areKnown || sides.Normals.size() == before + 3) // there is one side alone
      {
        sides.Normals.resize(before);
        for (const Id corner : corners)
        {
          sides.OfCorners[corner] = -1;
        }
      }
    });
  return sides;
}

template <typename Id>
void SplitSides(const SharpSides& sides, const PolygonMesh<Id>& mesh, vtkPolyData* output)
{
  std::vector<vtkIdType> sources(static_cast<std::size_t>(output->GetNumberOfPoints()));
  std::iota(sources.begin(), sources.end(), vtkIdType(0));
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> points; // of vertices and sides
  std::vector<bool> isUsed(sources.size());
  for (const vtkIdType corner : InTurn(sides.OfCorners.size()))
  {
    const auto vertex = static_cast<vtkIdType>(mesh.Vertices[corner]);
    const auto next = isUsed[vertex] ? static_cast<vtkIdType>(sources.size()) : vertex;
    if (sides.OfCorners[corner] >= 0 &&
      points.emplace(std::make_pair(vertex, sides.OfCorners[corner]), next).second)
    {
      isUsed[vertex] ? sources.push_back(vertex) : void();
      isUsed[vertex] = true;
    }
  }
  output->GetPointData()->SetGlobalIds(nullptr); // which would be there twice
  const vtkIdType before = output->GetNumberOfVerts() + output->GetNumberOfLines();
  TakePoints(output, sources,
    [&](vtkIdType cell, auto* begin, auto* end)
    {
      for (auto* id = begin; cell >= before && id < end; ++id)
      {
        const vtkIdType corner = mesh.GetFirst(static_cast<Id>(cell - before)) + (id - begin);
        const auto found = points.find({ *id, sides.OfCorners[corner] });
        *id = found == points.end() ? *id : static_cast<std::decay_t<decltype(*id)>>(found->second);
      }
    });
  vtkDataArray* normals = output->GetPointData()->GetArray(LimitNormalsName);
  for (const auto& [key, point] : points)
  {
    normals->SetTuple(point, sides.Normals.data() + 3 * key.second);
  }
}

SUBDIVISION_COMPILE_FUNCTION(FindSharpSides);
SUBDIVISION_COMPILE_FUNCTION(SplitSides);

}
