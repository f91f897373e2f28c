// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceFrames.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Operators/ForBlocks.h"
#include "Core/Operators/ShadingNormals.h"
#include "Core/Operators/Sums.h"
#include "Core/Surfaces/Scheme/ShadingDescent.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
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
template <typename Id, typename Real>
class FrameBlock
{
public:
  FrameBlock(const SurfaceScheme<Id>& scheme, const typename SurfaceSteps<Id>::AppendLimits& append,
    const Real* points, double largest)
    : Scheme(scheme)
    , Append(append)
    , Points(points)
    , Largest(largest)
  {
  }

  void Sum(vtkIdType begin, vtkIdType end)
  {
    this->First = begin;
    this->Rows[0].Clear();
    this->Append(LimitKind::Tangent1, begin, end, this->Rows[0]);
    this->Rows[0].ForRuns(0, [&](const auto& run) { this->SumBoth(run); });
  }
  void Turn(vtkIdType i)
  {
    std::transform(this->Values[1] + 3 * i, this->Values[1] + 3 * i + 3, this->Values[1] + 3 * i,
      std::negate<>());
  }
  const double* GetTangent(int which, vtkIdType i) const { return this->Values[which] + 3 * i; }
  /// Finds a normal, or, where there is none, the first tangent; then returns false.
  bool FindNormalOf(vtkIdType i, double normal[3])
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
      error += GetTangentError(this->Rows[1], 0, this->Points, Unit);
    }
    FindNormal(a, b, error, normal);
    const bool isFound = std::any_of(normal, normal + 3, [](double value) { return value != 0.; });
    std::copy_n(a, isFound ? 0 : 3, normal);
    return isFound;
  }

private:
  static constexpr double Unit = std::is_same<Real, float>::value ? SingleUnit : DoubleUnit;

  /// The tangents of vertices whose rows of the first tangent are `run`.
  template <typename Run>
  void SumBoth(const Run& run)
  {
    if constexpr (std::is_same<Run, EqualRows<Id>>::value)
    {
      if (const double* second = this->Scheme.GetSecondTangent(run.Weights))
      {
        this->SetBounds(0, run.FirstRow, run.Count, run.Weights, run.Size);
        this->SetBounds(1, run.FirstRow, run.Count, second, run.Size);
        const bool isAround = run.Weights[0] == 0. && second[0] == 0.;
        return isAround && run.Size == 7 ? this->SumPairs<7, 1>(run, second)
          : isAround && run.Size == 9    ? this->SumPairs<9, 1>(run, second)
          : isAround                     ? this->SumPairs<0, 1>(run, second)
                                         : this->SumPairs<0, 0>(run, second);
      }
    }
    const auto sum = [&](int which, LimitKind kind)
    {
      const vtkIdType begin = this->First + run.FirstRow;
      this->Rows[1].Clear();
      this->Append(kind, begin, begin + run.Count, this->Rows[1]);
      this->SumRows(which, this->Rows[1].GetRows(run.FirstRow));
    };
    if constexpr (std::is_same<Run, WeightedRows<Id>>::value)
    {
      this->SumRows(0, run);
    }
    else
    {
      sum(0, LimitKind::Tangent1);
    }
    sum(1, LimitKind::Tangent2);
  }
  /// Both tangents in one pass over the columns, which they share. The own vertex counts for
  /// neither where `First` is 1. `Size` as of SumEqualRows.
  template <int Size, int First>
  void SumPairs(const EqualRows<Id>& run, const double* second)
  {
    const int size = Size == 0 ? run.Size : Size;
    std::vector<double> weights;
    for (int k = 0; k < size; ++k)
    {
      weights.insert(weights.end(), { run.Weights[k], second[k] });
    }
    const Id* columns = run.Columns;
    Sums<2> sums[3]; // of each coordinate, for both
    for (vtkIdType row = 3 * run.FirstRow; row < 3 * (run.FirstRow + run.Count); row += 3)
    {
      for (Sums<2>& sum : sums)
      {
        sum.Clear();
      }
      for (int k = First; k < size; ++k)
      {
        const Real* point = this->Points + 3 * static_cast<vtkIdType>(columns[k]);
        sums[0].Add(static_cast<double>(point[0]), weights.data() + 2 * k);
        sums[1].Add(static_cast<double>(point[1]), weights.data() + 2 * k);
        sums[2].Add(static_cast<double>(point[2]), weights.data() + 2 * k);
      }
      for (int c = 0; c < 3; ++c)
      {
        this->Values[0][row + c] = sums[c][0];
        this->Values[1][row + c] = sums[c][1];
      }
      columns += size;
    }
  }
  void SetBounds(int which, vtkIdType row, vtkIdType count, const double* weights, vtkIdType size)
  {
    std::fill_n(
      this->Bounds[which] + row, count, GetTangentBound(weights, size, this->Largest, Unit));
  }
  void SumRows(int which, const WeightedRows<Id>& rows)
  {
    Sums<3> sums;
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      const Id* column = rows.Columns + rows.Offsets[i];
      const double* weights = rows.Weights + rows.Offsets[i];
      const vtkIdType size = rows.Offsets[i + 1] - rows.Offsets[i];
      this->SetBounds(which, rows.FirstRow + i, 1, weights, size);
      sums.Clear();
      for (vtkIdType k = size > 0 && weights[0] == 0. ? 1 : 0; k < size; ++k)
      {
        sums.Add(weights[k], this->Points + 3 * static_cast<vtkIdType>(column[k]));
      }
      sums.Write(this->Values[which] + 3 * (rows.FirstRow + i));
    }
  }

  const SurfaceScheme<Id>& Scheme;
  const typename SurfaceSteps<Id>::AppendLimits& Append;
  const Real* const Points;
  const double Largest;
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

/// Writes the tangents and normals that `frames` has room for. Real: of points and normals.
template <typename Id, typename Real>
void WriteFrames(const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& turned,
  vtkDataArray* points, LimitFrames& frames)
{
  const vtkIdType rows = points->GetNumberOfTuples();
  const auto* x = static_cast<const Real*>(points->GetVoidPointer(0));
  auto* normals = frames.Normals ? static_cast<Real*>(frames.Normals->GetVoidPointer(0)) : nullptr;
  const double largest = FindLargest(x, 3 * rows);
  Buffer<unsigned char> missing(normals ? rows : 0);
  Buffer<double> others(3 * missing.size()); // what is missing: few pages are touched
  std::atomic<bool> areMissing{ false };
  const SurfaceLevel<Id>& level = steps.GetLevel(steps.GetNumberOfSteps());
  const bool hasTags = !steps.GetScheme().IsDual();
  const auto append = steps.MakeLimits();
  const auto write = [&](FrameBlock<Id, Real>& block, vtkIdType begin, vtkIdType end)
  {
    block.Sum(begin, end);
    for (vtkIdType v = begin; v < end; ++v)
    {
      const Id face = turned.empty() ? -1 : FindOrientingFace(level, hasTags, static_cast<Id>(v));
      if (face >= 0 && turned[face])
      {
        block.Turn(v - begin);
      }
      for (int k = 0; k < 2 && !frames.Tangents[k].empty(); ++k)
      {
        std::copy_n(block.GetTangent(k, v - begin), 3, frames.Tangents[k].begin() + 3 * v);
      }
      if (!normals)
      {
        continue;
      }
      double normal[3];
      missing[v] = !block.FindNormalOf(v - begin, normal);
      if (!missing[v])
      {
        std::transform(normal, normal + 3, normals + 3 * v, [](double c) { return Real(c); });
        continue;
      }
      std::copy_n(normal, 3, others.begin() + 3 * v);
      areMissing = true;
    }
  };
  ForRanges(rows,
    [&](vtkIdType first, vtkIdType last)
    {
      FrameBlock<Id, Real> block(steps.GetScheme(), append, x, largest);
      ForBlocks(first, last, [&](vtkIdType begin, vtkIdType end) { write(block, begin, end); });
    });
  if (!areMissing)
  {
    return;
  }
  Buffer<double> converted;
  const double* all = ReadDoubles(x, points->GetDataType(), 3 * rows, converted);
  steps.GetLevelOfLimits() ? FindMissingNormals(steps, missing, all, others.data())
                           : FindShadingNormals(steps.GetScheme(), level, steps.GetSharpCreases(),
                               turned, missing, all, others.data());
  ForEach(rows,
    [&](vtkIdType v)
    {
      std::transform(others.begin() + 3 * v, others.begin() + (missing[v] ? 3 * v + 3 : 3 * v),
        normals + 3 * v, [](double c) { return Real(c); });
    });
}

}

template <typename Id>
LimitFrames FindLimitFrames(const SurfaceSteps<Id>& steps, const Buffer<unsigned char>& turned,
  vtkDataArray* points, bool normals, bool tangents)
{
  LimitFrames frames;
  for (Buffer<double>& values : frames.Tangents)
  {
    values = Buffer<double>(tangents ? 3 * points->GetNumberOfTuples() : 0);
  }
  if (normals)
  {
    frames.Normals = MakeArray(points->GetDataType(), 3, points->GetNumberOfTuples());
    frames.Normals->SetName(LimitNormalsName);
  }
  points->GetDataType() == VTK_FLOAT ? WriteFrames<Id, float>(steps, turned, points, frames)
                                     : WriteFrames<Id, double>(steps, turned, points, frames);
  return frames;
}

SUBDIVISION_COMPILE_FUNCTION(FindNormals);
SUBDIVISION_COMPILE_FUNCTION(SpreadTurned);
SUBDIVISION_COMPILE_FUNCTION(FindLimitFrames);

}
