// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceFrames.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Surfaces/Scheme/ShadingDescent.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"

#include "vtkDataArray.h"

namespace subdivision
{

template <typename Id>
void FindNormals(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const Buffer<unsigned char>& turned, const double* points,
  TangentPairs& tangents)
{
  tangents.Normals = Buffer<double>(3 * tangents.Errors.size());
  Buffer<unsigned char> missing(level.Mesh.NumberOfVertices);
  ForEach(tangents.Errors.size(),
    [&](vtkIdType i)
    {
      const double* a = tangents.Values[0].data() + 3 * i;
      const double* b = tangents.Values[1].data() + 3 * i;
      double* normal = tangents.Normals.data() + 3 * i;
      FindNormal(a, b, tangents.Errors[i], normal);
      const bool isMissing =
        std::all_of(normal, normal + 3, [](double value) { return value == 0.; });
      if (i < missing.size())
      {
        missing[i] = isMissing;
      }
      else if (isMissing)
      {
        FindPerpendicular(
          std::hypot(a[0], a[1], a[2]) < std::hypot(b[0], b[1], b[2]) ? b : a, normal);
      }
    });
  FindShadingNormals(scheme, level, creases, turned, missing, points, tangents.Values[0].data(),
    tangents.Normals.data());
}

template <typename Id>
Buffer<unsigned char> SpreadTurned(const SurfaceSteps<Id>& steps, Buffer<unsigned char>&& turned)
{
  for (int step = 0; step < steps.GetNumberOfSteps() && !turned.empty(); ++step)
  {
    Buffer<unsigned char> children(steps.GetLevel(step + 1).Mesh.NumberOfFaces);
    ForEach(children.size(), [&](vtkIdType f)
      { children[f] = turned[steps.GetScheme().GetOrientingFace(steps.GetLevel(step), f)]; });
    turned = std::move(children);
  }
  return std::move(turned);
}

template <typename Id>
TangentPairs FindLimitTangents(const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& turned,
  vtkDataArray* points, bool normals)
{
  const int type = points->GetDataType();
  const vtkIdType rows = points->GetNumberOfTuples();
  TangentPairs tangents(rows);
  Buffer<double> converted;
  const double* x = ReadDoubles(points->GetVoidPointer(0), type, 3 * rows, converted);
  const double unit = type == VTK_FLOAT ? SingleUnit : DoubleUnit;
  auto apply = [&](LimitKind kind, double* values)
  {
    steps.GetLimit(kind).ForRows(
      [&](const RowBlock<Id>& block, vtkIdType first)
      {
        block.Apply(x, values + 3 * first, 3);
        for (std::size_t row = 0; row < block.GetNumberOfRows(); ++row)
        {
          tangents.Errors[first + static_cast<vtkIdType>(row)] +=
            GetTangentError(block, row, x, unit);
        }
      });
  };
  apply(LimitKind::Tangent1, tangents.Values[0].data());
  apply(LimitKind::Tangent2, tangents.Values[1].data());
  const SurfaceLevel<Id>& level = steps.GetLevel(steps.GetNumberOfSteps());
  const bool hasTags = !steps.GetScheme().IsDual();
  TurnTangents(
    turned,
    [&level, hasTags](vtkIdType v)
    {
      const Id vertex = static_cast<Id>(v);
      const Id corner = hasTags ? Id(-1) : GetFirstFan(level.Mesh, vertex);
      return hasTags  ? FindFaceOfTangents(level.Mesh, level.Tags, vertex)
        : corner >= 0 ? level.Mesh.GetFace(corner)
                      : Id(-1);
    },
    tangents);
  if (normals)
  {
    FindNormals(steps.GetScheme(), level, steps.GetSharpCreases(), turned, x, tangents);
  }
  return tangents;
}

SUBDIVISION_COMPILE_FUNCTION(FindNormals);
SUBDIVISION_COMPILE_FUNCTION(SpreadTurned);
SUBDIVISION_COMPILE_FUNCTION(FindLimitTangents);

}
