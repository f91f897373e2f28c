// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SharpSides.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Vectors.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Operators/TangentErrors.h"
#include "Private/ArrayNames.h"
#include "Private/Values/PointCopies.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

namespace subdivision
{
namespace
{

/// Finds the normal of the limit in a sector. False: its ends are not those of the curve through
/// the vertex, and this is no corner.
template <typename Id>
bool FindNormalOfSector(const SurfaceLevel<Id>& level, LimitFinder<Id>& finder, Id corner,
  const SectorEnds<Id>& ends, const double* points, double normal[3])
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id vertex = mesh.Vertices[corner];
  const VertexTag tag = level.Tags.Vertices[vertex];
  std::vector<Id> curve;
  CollectCurveEdges(mesh, level.Tags, vertex, curve);
  for (const Id end : { ends.First.GetHalfEdgeIn(mesh), ends.Last.GetHalfEdgeOut(mesh) })
  {
    if (ends.Size == 0 || tag == VertexTag::Blend ||
      (tag == VertexTag::Curve && std::count(curve.begin(), curve.end(), mesh.Edges[end]) == 0))
    {
      return false;
    }
  }
  double tangents[2][3];
  double error = 0.;
  RowBlock<Id> row;
  for (const LimitKind kind : { LimitKind::Tangent1, LimitKind::Tangent2 })
  {
    row.Clear();
    finder.AppendOfSector(corner, kind, row);
    row.Apply(points, tangents[kind == LimitKind::Tangent2], 3);
    error += GetTangentError(row, 0, points, SingleUnit);
  }
  return FindClearNormal(tangents[0], tangents[1], error, normal);
}

/// The mean of the normals at corners.
template <typename Id>
void FindMeanNormal(const PolygonMesh<Id>& mesh, const std::vector<Id>& corners,
  const Buffer<unsigned char>& turned, const double* points, double normal[3])
{
  const auto at = [&](Id corner) { return points + 3 * vtkIdType(mesh.Vertices[corner]); };
  ShadingStar star;
  for (const Id corner : corners)
  {
    const auto a = vectors::Subtract(at(mesh.Next(corner)), at(corner));
    const auto b = vectors::Subtract(at(mesh.Previous(corner)), at(corner));
    const double middle[3] = { (a[0] + b[0]) / 3., (a[1] + b[1]) / 3., (a[2] + b[2]) / 3. };
    star.AddCorner(
      a.data(), b.data(), middle, !turned.empty() && turned[mesh.GetFace(corner)] ? -1. : 1.);
  }
  star.FindNormal(normal);
}

}

template <typename Id>
SharpSides FindSharpSides(const SurfaceLevel<Id>& level, LimitFinder<Id>* finder,
  const Buffer<unsigned char>& turned, vtkDataArray* points)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  SharpSides sides{ Buffer<vtkIdType>(mesh.Vertices.size(), -1), {} };
  Buffer<double> converted;
  const double* x = ReadDoubles(
    points->GetVoidPointer(0), points->GetDataType(), points->GetNumberOfValues(), converted);
  std::vector<Id> all;
  std::vector<Id> own;
  const auto listFan = [&mesh](Id corner, std::vector<Id>& corners)
  { VisitFan(mesh, corner, [&](const FanStep<Id>& s) { corners.push_back(s.Corner); }); };
  ForEachInTurn(mesh.NumberOfVertices,
    [&](vtkIdType v)
    {
      const auto before = sides.Normals.size();
      all.clear();
      if (level.Tags.Vertices[v] != VertexTag::Smooth || mesh.FindJoint(static_cast<Id>(v)))
      {
        VisitFans(mesh, static_cast<Id>(v), [&](Id corner) { listFan(corner, all); });
      }
      for (const Id corner : all)
      {
        if (sides.OfCorners[corner] >= 0)
        {
          continue;
        }
        const SectorEnds<Id> ends = FindSectorEnds(mesh, level.Tags, corner);
        own.clear();
        FanStep<Id> step = ends.First;
        for (int i = 0; i < ends.Size; ++i, step.Advance(mesh))
        {
          own.push_back(step.Corner);
        }
        own.empty() ? listFan(corner, own) : void();
        for (const Id one : own)
        {
          sides.OfCorners[one] = static_cast<vtkIdType>(sides.Normals.size() / 3);
        }
        double normal[3];
        if (!finder || !FindNormalOfSector(level, *finder, corner, ends, x, normal))
        {
          FindMeanNormal(mesh, own, turned, x, normal);
        }
        else if (!turned.empty() && turned[mesh.GetFace(ends.First.Corner)])
        {
          std::transform(normal, normal + 3, normal, std::negate<>());
        }
        sides.Normals.insert(sides.Normals.end(), normal, normal + 3);
      }
      if (sides.Normals.size() == before + 3) // there is one side alone
      {
        sides.Normals.resize(before);
        for (const Id corner : all)
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
    const auto next = static_cast<vtkIdType>(sources.size());
    if (sides.OfCorners[corner] >= 0 &&
      points
        .emplace(std::make_pair(vertex, sides.OfCorners[corner]), isUsed[vertex] ? next : vertex)
        .second)
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
