// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceFrames.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Surfaces/Scheme/ShadingDescent.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"
#include "Private/Arrays/Arrays.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace subdivision
{

namespace
{

/// Three numbers for each point, whatever type they are stored in.
Buffer<double> ReadPoints(vtkDataArray* points)
{
  const vtkIdType size = points->GetNumberOfValues();
  Buffer<double> values(size);
  const void* stored = points->GetVoidPointer(0);
  const bool isSingle = points->GetDataType() == VTK_FLOAT;
  ForEach(size,
    [&](vtkIdType i)
    {
      values[i] =
        isSingle ? static_cast<const float*>(stored)[i] : static_cast<const double*>(stored)[i];
    });
  return values;
}

}

template <typename Id>
void FindNormals(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const Buffer<unsigned char>& turned, const double* points,
  TangentPairs& tangents)
{
  // Never empty: that there are normals shows in the output of a rank without points, too.
  tangents.Normals = Buffer<double>(std::max<vtkIdType>(1, 3 * tangents.Errors.size()));
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

void AddLimitFrames(const TangentPairs& tangents, vtkDataArray* points,
  const Buffer<vtkIdType>& sources, bool twoTangents, vtkPolyData* input, vtkPolyData* output)
{
  const int type = points->GetDataType();
  const vtkIdType size = sources.empty() ? tangents.Errors.size() : sources.size();
  auto add = [&](const char* name, const auto& value)
  {
    const auto array = MakeArray(type, 3, size);
    array->SetName(name);
    auto fill = [&](auto* out)
    {
      using T = typename std::remove_pointer<decltype(out)>::type;
      ForEach(size,
        [&](vtkIdType i)
        {
          double result[3];
          value(sources.empty() ? i : sources[i], result);
          for (int c = 0; c < 3; ++c)
          {
            out[3 * i + c] = static_cast<T>(result[c]);
          }
        });
    };
    if (type == VTK_FLOAT)
    {
      fill(static_cast<float*>(array->GetVoidPointer(0)));
    }
    else
    {
      fill(static_cast<double*>(array->GetVoidPointer(0)));
    }
    AddInstead(input->GetPointData(), array, output->GetPointData());
  };
  if (!tangents.Normals.empty())
  {
    add(LimitNormalsName,
      [&](vtkIdType i, double* n) { std::copy_n(tangents.Normals.data() + 3 * i, 3, n); });
  }
  for (int t = 0; t < 2 && twoTangents; ++t)
  {
    add(LimitTangentNames[t],
      [&](vtkIdType i, double* out) { std::copy_n(tangents.Values[t].data() + 3 * i, 3, out); });
  }
}

void MoveLimitFramesToEnd(vtkPolyData* output)
{
  for (const char* name : { LimitNormalsName, LimitTangentNames[0], LimitTangentNames[1] })
  {
    MoveToEnd(name, output->GetPointData());
  }
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
  const Buffer<double> x = ReadPoints(points);
  const double unit = type == VTK_FLOAT ? SingleUnit : DoubleUnit;
  auto apply = [&](LimitKind kind, double* values)
  {
    steps.GetLimit(kind).ForRows(
      [&](const RowBlock<Id>& block, vtkIdType first)
      {
        block.Apply(x.data(), values + 3 * first, 3);
        for (std::size_t row = 0; row < block.GetNumberOfRows(); ++row)
        {
          tangents.Errors[first + static_cast<vtkIdType>(row)] +=
            GetTangentError(block, row, x.data(), unit);
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
    FindNormals(steps.GetScheme(), level, steps.GetSharpCreases(), turned, x.data(), tangents);
  }
  return tangents;
}

SUBDIVISION_COMPILE_FUNCTION(FindNormals);
SUBDIVISION_COMPILE_FUNCTION(SpreadTurned);
SUBDIVISION_COMPILE_FUNCTION(FindLimitTangents);

}
