// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Dual/MidedgeLater.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Dual/DualPlaces.h"
#include "Core/Surfaces/Dual/MidedgeWeights.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include <array>

namespace subdivision
{
namespace
{

template <typename Id>
void Prepare(SurfaceLevel<Id>& level)
{
  const vtkIdType corners = level.Mesh.GetNumberOfCorners();
  level.Later = Buffer<Id>(2 * corners);
  Id* const places = level.Later.data();
  Id* const atPlaces = places + corners;
  const auto set = [&](Id vertex, const auto& visitFans)
  {
    Id at = level.Dual->Corners[vertex];
    visitFans(
      [&](Id, const std::vector<FanStep<Id>>& steps, bool)
      {
        for (const FanStep<Id>& step : steps)
        {
          places[step.Corner] = at;
          atPlaces[at++] = step.Corner;
        }
      });
  };
  ForRanges(level.Mesh.NumberOfVertices,
    [&](vtkIdType begin, vtkIdType end) { ForFansForward(level.Mesh, begin, end, set); });
}

/// The level two steps later, from this one: "along" is a corner of the face along a side, which
/// has the vertices of the side's first corner, of the one before it, and the same of its twin;
/// "around" one of the face around a vertex, which has those of the corners before the vertex's
/// corners.
template <typename Id>
class LevelAfterNext
{
public:
  explicit LevelAfterNext(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Sides(level.Dual->Sides)
    , Corners(static_cast<Id>(level.Mesh.GetNumberOfCorners()))
    , Places(level.Later.data())
  {
  }

  bool IsFirst(Id corner) const { return corner < this->Mesh.Twins[corner]; }
  /// The first corner of a side.
  Id FindFirst(vtkIdType side) const { return FindByCount(this->Sides, side); }
  Id GetFirstAlong(Id corner) const
  {
    return 2 * this->Corners + 4 * this->Sides[GetFirstOfSide(this->Mesh, corner)];
  }
  /// The corner along a corner's side that has its vertex.
  Id GetAlong(Id corner) const
  {
    return this->GetFirstAlong(corner) + (this->IsFirst(corner) ? 0 : 2);
  }
  /// The one before it in the same face.
  Id GetAlongBefore(Id corner) const
  {
    return this->GetFirstAlong(corner) + (this->IsFirst(corner) ? 3 : 1);
  }
  /// The corner around a corner's vertex, and those before and after it in the same face.
  Id GetAround(Id corner) const { return this->Corners + this->Places[corner]; }
  Id GetAroundBefore(Id corner) const
  {
    return this->GetAround(this->Mesh.Next(this->Mesh.Twins[corner]));
  }
  Id GetAroundAfter(Id corner) const
  {
    return this->GetAround(this->Mesh.Twins[this->Mesh.Previous(corner)]);
  }
  /// The corner at a place around vertices.
  Id GetCornerAt(vtkIdType place) const { return this->Places[this->Corners + place]; }

  const PolygonMesh<Id>& Mesh;
  const Buffer<Id>& Sides;
  const Id Corners;

private:
  const Id* const Places;
};

template <typename Id>
using Ends = std::array<Id, 2>;

/// Appends rows of two ends each: ends(i) for i of [begin, end), in order.
template <typename Id, typename GetEnds>
void AppendMiddles(vtkIdType begin, vtkIdType end, const GetEnds& ends, RowBlock<Id>& rows)
{
  rows.AddRun(MidedgeMiddle, end - begin,
    [&](vtkIdType i, Id* columns)
    {
      const Ends<Id> row = ends(begin + i);
      columns[0] = row[0];
      columns[1] = row[1];
      return true;
    });
}

/// The rows of sides inside old faces, whether they read the vertices or the sides of the level two
/// steps later: both have the numbers of corners.
template <typename Id>
void AppendInside(const PolygonMesh<Id>& mesh, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  AppendMiddles(
    begin, end,
    [&](vtkIdType i)
    {
      const Id corner = static_cast<Id>(i);
      return Ends<Id>{ corner, mesh.Next(corner) };
    },
    rows);
}

/// In the step from the level two steps later a side becomes a vertex.
template <typename Id>
void AppendSides(
  const LevelAfterNext<Id>& later, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = later.Mesh;
  ForKindsOfRows<2>({ later.Corners, later.Corners }, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      if (kind == 0)
      {
        return AppendInside(mesh, first, last, rows);
      }
      AppendMiddles(
        first, last,
        [&](vtkIdType i)
        {
          const Id before = mesh.Previous(later.GetCornerAt(i));
          return Ends<Id>{ before, mesh.Previous(mesh.Twins[before]) };
        },
        rows);
    });
}

/// The rows of the corners along sides, which are across the sides of the four faces around.
template <typename Id>
void AppendAlong(
  const LevelAfterNext<Id>& later, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = later.Mesh;
  Id corner = later.FindFirst(begin / 4) - 1;
  std::array<Id, 4> sides{};
  const auto findNext = [&]
  {
    do
    {
      ++corner;
    } while (!later.IsFirst(corner));
    const Id twin = mesh.Twins[corner];
    sides = { mesh.Previous(corner), later.GetAround(mesh.Next(twin)), mesh.Previous(twin),
      later.GetAround(mesh.Next(corner)) };
  };
  if (begin % 4 != 0)
  {
    findNext();
  }
  AppendMiddles(
    begin, end,
    [&](vtkIdType i)
    {
      if (i % 4 == 0)
      {
        findNext();
      }
      return Ends<Id>{ sides[i % 4], sides[(i + 1) % 4] };
    },
    rows);
}

/// In the step after that a corner becomes a vertex, between its side and the next one.
template <typename Id>
void AppendCorners(
  const LevelAfterNext<Id>& later, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  ForKindsOfRows<3>({ later.Corners, later.Corners, 2 * static_cast<vtkIdType>(later.Corners) },
    begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      switch (kind)
      {
        case 0:
          return AppendInside(later.Mesh, first, last, rows);
        case 1:
          return AppendMiddles(
            first, last,
            [&](vtkIdType i)
            {
              return Ends<Id>{ static_cast<Id>(later.Corners + i),
                later.GetAroundAfter(later.GetCornerAt(i)) };
            },
            rows);
        default:
          return AppendAlong(later, first, last, rows);
      }
    });
}

template <typename Id>
void AppendRows(
  const SurfaceLevel<Id>& level, int ahead, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const LevelAfterNext<Id> later(level);
  ahead == 2 ? AppendSides(later, begin, end, rows) : AppendCorners(later, begin, end, rows);
}

template <typename Id>
void GetParents(
  const SurfaceLevel<Id>& level, int ahead, vtkIdType row, std::vector<vtkIdType>& parents)
{
  ListColumns<Id>(
    [&](RowBlock<Id>& rows) { AppendRows(level, ahead, row, row + 1, rows); }, parents);
}

/// Of the level four steps later: faces inside those of the level two steps later, at its vertices,
/// and at its sides. Their vertices are corners of the level two steps later.
template <typename Id, typename Out>
void WriteFaces(const SurfaceLevel<Id>& level, Out* ids)
{
  const LevelAfterNext<Id> later(level);
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType corners = later.Corners;
  ForEach(4 * corners, [&](vtkIdType c) { ids[c] = static_cast<Out>(c); });
  Out* const atVertices = ids + 4 * corners;
  Out* const atInside = ids + 8 * corners;
  Out* const atAround = ids + 12 * corners;
  ForEach(corners,
    [&](vtkIdType c)
    {
      const Id corner = static_cast<Id>(c);
      const Id next = mesh.Next(corner);
      WriteFace(atVertices + 4 * c, mesh.Previous(corner), later.GetAlongBefore(corner),
        later.GetAroundBefore(next), later.GetAlong(next));
    });
  ForEach(corners,
    [&](vtkIdType c)
    {
      const Id corner = static_cast<Id>(c);
      const Id next = mesh.Next(corner);
      WriteFace(atInside + 4 * c, corner, mesh.Previous(corner), later.GetAlong(next),
        later.GetAlongBefore(next));
    });
  ForEach(corners,
    [&](vtkIdType place)
    {
      const Id corner = later.GetCornerAt(place);
      const Id along = later.GetAlongBefore(mesh.Previous(corner));
      WriteFace(atAround + 4 * place, static_cast<Id>(corners + place),
        later.GetAroundBefore(corner), along, along - 1);
    });
}

}

template <typename Id>
StepsOfLater<Id> MakeMidedgeStepsOfLater()
{
  return { Prepare<Id>, AppendRows<Id>, GetParents<Id>,
    [](const SurfaceLevel<Id>& level, IdsOut ids)
    { std::visit([&level](auto* to) { WriteFaces(level, to); }, ids); } };
}

SUBDIVISION_COMPILE_FUNCTION(MakeMidedgeStepsOfLater);

}
