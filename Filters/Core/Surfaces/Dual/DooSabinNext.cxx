// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Dual/DooSabinNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Dual/DooSabinWeights.h"
#include "Core/Surfaces/Dual/DualNext.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace subdivision
{
namespace
{

/// The next level, from this one. Its vertices are the corners of this one.
template <typename Id>
class NextLevel
{
public:
  explicit NextLevel(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Places(*level.Dual)
    , Corners(static_cast<Id>(level.Mesh.GetNumberOfCorners()))
  {
  }

  bool IsFirst(Id corner) const { return corner < this->Mesh.Twins[corner]; }
  Id GetSide(Id corner) const { return this->Places.Sides[GetFirstOfSide(this->Mesh, corner)]; }
  /// Where the face along a corner's side has the vertex made at the corner, and where that made at
  /// the corner after it: as corners of the next level.
  Id GetAlong(Id corner) const
  {
    return this->Corners + 4 * this->GetSide(corner) + (this->IsFirst(corner) ? 1 : 3);
  }
  Id GetAlongOfNext(Id corner) const { return this->GetAlong(corner) - 1; }
  /// The first corner of the next level in the face around a vertex.
  Id GetAround(vtkIdType vertex) const { return 3 * this->Corners + this->Places.Corners[vertex]; }

  /// The vertices of the face along the side of its first corner.
  std::array<Id, 4> GetFaceAlong(Id corner) const
  {
    const Id twin = this->Mesh.Twins[corner];
    return { this->Mesh.Next(corner), corner, this->Mesh.Next(twin), twin };
  }

  const PolygonMesh<Id>& Mesh;
  const DualPlaces<Id>& Places;
  const Id Corners;
};

/// Appends the rows at corners [begin, end) of a face with these vertices.
template <typename Id, typename GetVertex>
void AppendCorners(
  vtkIdType size, vtkIdType begin, vtkIdType end, const GetVertex& getVertex, RowBlock<Id>& rows)
{
  if (size == 4)
  {
    AppendQuads(
      DooSabinQuad, begin, end,
      [&](vtkIdType, Id* corners)
      {
        for (vtkIdType k = 0; k < 4; ++k)
        {
          corners[k] = getVertex(k);
        }
      },
      rows);
    return;
  }
  const auto get = [&](vtkIdType k) { return getVertex(k < size ? k : k - size); };
  thread_local std::vector<double> weights;
  if (static_cast<vtkIdType>(weights.size()) != size)
  {
    FindCornerWeights(size, weights);
  }
  for (vtkIdType j = begin; j < end; ++j)
  {
    for (vtkIdType k = 0; k < size; ++k)
    {
      rows.Add(get(j + k), weights[k]);
    }
    rows.EndRow();
  }
}

template <typename Id>
void AppendInside(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  while (begin < end)
  {
    const Id face = next.Mesh.GetFace(static_cast<Id>(begin));
    const Id first = next.Mesh.GetFirst(face);
    const vtkIdType size = next.Mesh.GetSize(face);
    if (first == begin)
    {
      const vtkIdType whole = rows.AddQuads(DooSabinQuad, (end - begin) / 4,
        [&](vtkIdType i, Id* corners)
        {
          std::iota(corners, corners + 4, static_cast<Id>(begin + 4 * i));
          return next.Mesh.GetSize(static_cast<Id>(face + i)) == 4;
        });
      begin += whole;
      if (whole > 0)
      {
        continue;
      }
    }
    const vtkIdType last = std::min(size, end - first);
    AppendCorners(
      size, begin - first, last, [first](vtkIdType k) { return static_cast<Id>(first + k); }, rows);
    begin = first + last;
  }
}

template <typename Id>
void AppendAlong(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  Id corner = FindByCount(next.Places.Sides, begin / 4);
  AppendQuads(
    DooSabinQuad, begin, end,
    [&](vtkIdType, Id* corners)
    {
      while (!next.IsFirst(corner))
      {
        ++corner;
      }
      const std::array<Id, 4> face = next.GetFaceAlong(corner++);
      std::copy(face.begin(), face.end(), corners);
    },
    rows);
}

template <typename Id>
void AppendAround(const NextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const Buffer<Id>& before = next.Places.Corners;
  const auto append = [&](Id vertex, const auto& visitFans)
  {
    visitFans(
      [&](Id, const std::vector<FanStep<Id>>& steps, bool)
      {
        const vtkIdType first = before[vertex];
        const vtkIdType size = static_cast<vtkIdType>(steps.size());
        AppendCorners(
          size, std::max<vtkIdType>(begin - first, 0), std::min(size, end - first),
          [&](vtkIdType k) { return steps[k].Corner; }, rows);
      });
  };
  ForFansForward(next.Mesh, FindByCount(before, begin), FindByCount(before, end - 1) + 1, append);
}

template <typename Id>
SurfaceLevel<Id> Count(const SurfaceLevel<Id>& skipped)
{
  const PolygonMesh<Id>& mesh = skipped.Mesh;
  const vtkIdType corners = mesh.GetFirstOfCounted(mesh.NumberOfFaces);
  return CountDual(skipped, corners, corners / 2 + mesh.NumberOfVertices);
}

template <typename Id>
void AppendRows(const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const NextLevel<Id> next(level);
  ForKindsOfRows<3>({ next.Corners, 2 * next.Corners, next.Corners }, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      kind == 0     ? AppendInside(next, first, last, rows)
        : kind == 1 ? AppendAlong(next, first, last, rows)
                    : AppendAround(next, first, last, rows);
    });
}

template <typename Id>
void GetParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents)
{
  ListColumns<Id>([&](RowBlock<Id>& rows) { AppendRows(level, row, row + 1, rows); }, parents);
}

template <typename Id, typename Out>
void WriteFaces(const SurfaceLevel<Id>& level, Out* ids)
{
  const NextLevel<Id> next(level);
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType corners = next.Corners;
  ForEach(4 * corners, [&](vtkIdType c) { ids[c] = static_cast<Out>(c); });
  Out* const alongSides = ids + 4 * corners;
  Out* const atVertices = ids + 12 * corners;
  // For each corner three faces: along the next level's side on the corner's half-edge, along that
  // between the face along the previous side and the one around the vertex, and at its vertex.
  const auto write = [&](Id vertex, const auto& visitFans)
  {
    const Id around = next.GetAround(vertex);
    visitFans(
      [&](Id, const std::vector<FanStep<Id>>& steps, bool)
      {
        const Id size = static_cast<Id>(steps.size());
        for (Id j = 0; j < size; ++j)
        {
          const Id corner = steps[j].Corner;
          const Id previous = mesh.Previous(corner);
          const Id along = next.GetAlong(corner);
          const Id before = next.GetAlongOfNext(previous);
          WriteFace(alongSides + 4 * static_cast<vtkIdType>(corner), mesh.Next(corner), corner,
            along, along - 1);
          // The twin of the previous corner begins at the vertex.
          const bool isFirst = !next.IsFirst(previous);
          const vtkIdType side =
            corners + 2 * static_cast<vtkIdType>(next.GetSide(previous)) + (isFirst ? 0 : 1);
          const Id quad = before - (before - next.Corners) % 4;
          WriteFace(alongSides + 4 * side, quad + (isFirst ? 2 : 0), quad + (isFirst ? 1 : 3),
            around + (j + 1 < size ? j + 1 : 0), around + j);
          WriteFace(
            atVertices + 4 * static_cast<vtkIdType>(corner), corner, before, around + j, along);
        }
      });
  };
  ForRanges(mesh.NumberOfVertices,
    [&](vtkIdType begin, vtkIdType end) { ForFansForward(mesh, begin, end, write); });
}

}

template <typename Id>
StepOfNext<Id> MakeDooSabinStepOfNext()
{
  return { IsClosedDual<Id>,
    [](const SurfaceLevel<Id>& level, const IrregularRows<Id>&, vtkIdType begin, vtkIdType end,
      RowBlock<Id>& rows) { AppendRows(level, begin, end, rows); },
    GetParents<Id>, [](const SurfaceLevel<Id>& level, IdsOut ids)
    { std::visit([&level](auto* to) { WriteFaces(level, to); }, ids); }, Count<Id> };
}

SUBDIVISION_COMPILE_FUNCTION(MakeDooSabinStepOfNext);

}
