// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceFrames.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/ForBlocks.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Surfaces/Scheme/ShadingDescent.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <functional>
#include <type_traits>

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
        std::copy_n(a, isMissing ? 3 : 0, normal);
      }
      else if (isMissing)
      {
        FindPerpendicular(
          std::hypot(a[0], a[1], a[2]) < std::hypot(b[0], b[1], b[2]) ? b : a, normal);
      }
    });
  FindShadingNormals(scheme, level, creases, turned, missing, points, tangents.Normals.data());
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

namespace
{

/// Tangents and normals of some vertices in a row, from their limit rows.
template <typename Id>
class FrameBlock
{
public:
  FrameBlock(const SurfaceScheme<Id>& scheme, const typename SurfaceSteps<Id>::AppendLimits& append,
    const double* points, double largest, double unit)
    : Scheme(scheme)
    , Append(append)
    , Points(points)
    , Largest(largest)
    , Unit(unit)
  {
  }

  void Sum(vtkIdType begin, vtkIdType end)
  {
    this->First = begin;
    this->Rows[0].Clear();
    this->Append(LimitKind::Tangent1, begin, end, this->Rows[0]);
    FindTangentErrors(this->Rows[0], this->Largest, this->Unit, this->Bounds[0]);
    this->Rows[0].ForRuns(0,
      [&](const auto& run)
      {
        SumRows(run, this->Points, this->Values[0], 3);
        this->SumSecond(run);
      });
  }
  void Turn(vtkIdType i)
  {
    std::transform(this->Values[1] + 3 * i, this->Values[1] + 3 * i + 3, this->Values[1] + 3 * i,
      std::negate<>());
  }
  const double* GetTangent(int which, vtkIdType i) const { return this->Values[which] + 3 * i; }
  /// Writes a normal, or, where there is none, the first tangent; then returns false.
  bool WriteNormal(vtkIdType i, double* normal)
  {
    const double* a = this->GetTangent(0, i);
    const double* b = this->GetTangent(1, i);
    if (FindClearNormal(a, b, this->Bounds[0][i] + this->Bounds[1][i], normal))
    {
      return true;
    }
    double error = 0.;
    for (const LimitKind kind : { LimitKind::Tangent1, LimitKind::Tangent2 })
    {
      this->Rows[1].Clear();
      this->Append(kind, this->First + i, this->First + i + 1, this->Rows[1]);
      error += GetTangentError(this->Rows[1], 0, this->Points, this->Unit);
    }
    FindNormal(a, b, error, normal);
    const bool isFound = std::any_of(normal, normal + 3, [](double value) { return value != 0.; });
    std::copy_n(a, isFound ? 0 : 3, normal);
    return isFound;
  }

private:
  /// The second tangents of vertices whose rows of the first tangent are `run`.
  template <typename Run>
  void SumSecond(const Run& run)
  {
    double* bounds = this->Bounds[1] + run.FirstRow;
    if constexpr (std::is_same<Run, EqualRows<Id>>::value)
    {
      if (const double* weights = this->Scheme.GetSecondTangent(run.Weights))
      {
        const EqualRows<Id> second{ run.FirstRow, run.Count, run.Size, run.Columns, weights };
        SumRows(second, this->Points, this->Values[1], 3);
        std::fill_n(
          bounds, run.Count, GetTangentBound(weights, run.Size, this->Largest, this->Unit));
        return;
      }
    }
    const vtkIdType begin = this->First + run.FirstRow;
    this->Rows[1].Clear();
    this->Append(LimitKind::Tangent2, begin, begin + run.Count, this->Rows[1]);
    this->Rows[1].ForRuns(
      run.FirstRow, [&](const RowsView& rows) { SumRows(rows, this->Points, this->Values[1], 3); });
    FindTangentErrors(this->Rows[1], this->Largest, this->Unit, bounds);
  }

  const SurfaceScheme<Id>& Scheme;
  const typename SurfaceSteps<Id>::AppendLimits& Append;
  const double* const Points;
  const double Largest;
  const double Unit;
  vtkIdType First = 0;
  RowBlock<Id> Rows[2];
  double Values[2][3 * BlockSize];
  double Bounds[2][BlockSize];
};

/// The face whose orientation the tangents of a vertex have, or -1.
template <typename Id>
Id FindOrientingFace(const SurfaceLevel<Id>& level, bool hasTags, Id vertex)
{
  const Id corner = hasTags ? Id(-1) : GetFirstFan(level.Mesh, vertex);
  return hasTags  ? FindFaceOfTangents(level.Mesh, level.Tags, vertex)
    : corner >= 0 ? level.Mesh.GetFace(corner)
                  : Id(-1);
}

/// FindShadingNormals where the last level is not made, which then has no turned faces.
template <typename Id>
void FindMissingNormals(const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& missing,
  const double* points, double* normals)
{
  std::vector<Id> vertices;
  std::vector<vtkIdType> parents;
  ForEachInTurn(missing.size(),
    [&](vtkIdType v)
    {
      if (missing[v])
      {
        steps.GetParents(steps.GetNumberOfSteps() - 1, v, parents);
        vertices.insert(vertices.end(), parents.begin(), parents.end());
      }
    });
  if (vertices.empty())
  {
    return;
  }
  SortUnique(vertices);
  const NextPatch<Id> patch(
    steps.GetScheme(), *steps.GetLevelOfLimits(), vertices, Depth::ForRefinement);
  const vtkIdType size = patch.GetNext().Mesh.NumberOfVertices;
  Buffer<unsigned char> ofPatch(size);
  Buffer<double> values[2] = { Buffer<double>(3 * size), Buffer<double>(3 * size) };
  ForEach(size,
    [&](vtkIdType v)
    {
      const vtkIdType vertex = patch.GetVertex(v);
      ofPatch[v] = missing[vertex];
      std::copy_n(points + 3 * vertex, 3, values[0].begin() + 3 * v);
      std::copy_n(normals + 3 * vertex, 3, values[1].begin() + 3 * v);
    });
  FindShadingNormals(
    steps.GetScheme(), patch.GetNext(), {}, {}, ofPatch, values[0].data(), values[1].data());
  ForEach(size, [&](vtkIdType v)
    { std::copy_n(values[1].begin() + 3 * v, 3, normals + 3 * vtkIdType(patch.GetVertex(v))); });
}

}

template <typename Id>
TangentPairs FindLimitTangents(const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& turned,
  vtkDataArray* points, bool normals, bool tangents)
{
  const int type = points->GetDataType();
  const vtkIdType rows = points->GetNumberOfTuples();
  TangentPairs pairs(0);
  Buffer<double> converted;
  const double* x = ReadDoubles(points->GetVoidPointer(0), type, 3 * rows, converted);
  const double largest = FindLargest(x, 3 * rows);
  for (Buffer<double>& values : pairs.Values)
  {
    values = Buffer<double>(tangents ? 3 * rows : 0);
  }
  pairs.Normals = Buffer<double>(normals ? 3 * rows : 0);
  Buffer<unsigned char> missing(normals ? rows : 0);
  const SurfaceLevel<Id>& level = steps.GetLevel(steps.GetNumberOfSteps());
  const bool hasTags = !steps.GetScheme().IsDual();
  const auto append = steps.MakeLimits();
  const auto write = [&](FrameBlock<Id>& block, vtkIdType begin, vtkIdType end)
  {
    block.Sum(begin, end);
    for (vtkIdType v = begin; v < end; ++v)
    {
      const Id face = turned.empty() ? -1 : FindOrientingFace(level, hasTags, static_cast<Id>(v));
      if (face >= 0 && turned[face])
      {
        block.Turn(v - begin);
      }
      for (int k = 0; k < 2 && tangents; ++k)
      {
        std::copy_n(block.GetTangent(k, v - begin), 3, pairs.Values[k].begin() + 3 * v);
      }
      if (normals)
      {
        missing[v] = !block.WriteNormal(v - begin, pairs.Normals.data() + 3 * v);
      }
    }
  };
  ForRanges(rows,
    [&](vtkIdType first, vtkIdType last)
    {
      FrameBlock<Id> block(
        steps.GetScheme(), append, x, largest, type == VTK_FLOAT ? SingleUnit : DoubleUnit);
      ForBlocks(first, last, [&](vtkIdType begin, vtkIdType end) { write(block, begin, end); });
    });
  if (normals)
  {
    steps.GetLevelOfLimits() ? FindMissingNormals(steps, missing, x, pairs.Normals.data())
                             : FindShadingNormals(steps.GetScheme(), level, steps.GetSharpCreases(),
                                 turned, missing, x, pairs.Normals.data());
  }
  return pairs;
}

SUBDIVISION_COMPILE_FUNCTION(FindNormals);
SUBDIVISION_COMPILE_FUNCTION(SpreadTurned);
SUBDIVISION_COMPILE_FUNCTION(FindLimitTangents);

}
