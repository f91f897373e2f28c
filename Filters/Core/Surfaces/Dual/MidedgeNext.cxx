// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Dual/MidedgeNext.h"

#include "Core/Memory/Ids.h"
#include "Core/Surfaces/Dual/DualNext.h"
#include "Core/Surfaces/Dual/MidedgeLater.h"
#include "Core/Surfaces/Dual/MidedgeWeights.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include <array>

namespace subdivision
{
namespace
{

/// The ends of the side of the next level across a corner: vertices of the next level.
template <typename Id>
std::array<Id, 2> GetEnds(const SurfaceLevel<Id>& level, Id corner)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Buffer<Id>& sides = level.Dual->Sides;
  return { sides[GetFirstOfSide(mesh, corner)], sides[GetFirstOfSide(mesh, mesh.Next(corner))] };
}

template <typename Id>
SurfaceLevel<Id> Count(const SurfaceLevel<Id>& skipped)
{
  const PolygonMesh<Id>& mesh = skipped.Mesh;
  return CountDual(skipped, mesh.GetFirstOfCounted(mesh.NumberOfFaces) / 2, mesh.NumberOfVertices);
}

template <typename Id>
void AppendRows(const SurfaceLevel<Id>& level, const IrregularRows<Id>&, vtkIdType begin,
  vtkIdType end, RowBlock<Id>& rows)
{
  rows.AddRun(MidedgeMiddle, end - begin,
    [&](vtkIdType i, Id* columns)
    {
      const std::array<Id, 2> ends = GetEnds(level, static_cast<Id>(begin + i));
      std::copy(ends.begin(), ends.end(), columns);
      return true;
    });
}

template <typename Id>
void GetParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents)
{
  const std::array<Id, 2> ends = GetEnds(level, static_cast<Id>(row));
  parents.assign(ends.begin(), ends.end());
}

template <typename Id, typename Out>
void WriteFaces(const SurfaceLevel<Id>& level, Out* ids)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const DualPlaces<Id>& places = *level.Dual;
  const vtkIdType corners = mesh.GetNumberOfCorners();
  // Inside this level's faces, then at its vertices.
  ForEach(corners, [&](vtkIdType c) { ids[c] = static_cast<Out>(c); });
  Out* const atVertices = ids + corners;
  const auto write = [&](Id vertex, const auto& visitFans)
  {
    Out* to = atVertices + places.Corners[vertex];
    visitFans(
      [&](Id, const std::vector<FanStep<Id>>& steps, bool)
      {
        for (const FanStep<Id>& step : steps)
        {
          *to++ = static_cast<Out>(mesh.Previous(step.Corner));
        }
      });
  };
  ForRanges(mesh.NumberOfVertices,
    [&](vtkIdType begin, vtkIdType end) { ForFansForward(mesh, begin, end, write); });
  // At the next level's vertices, which are the sides of this one.
  Out* const atSides = ids + 2 * corners;
  ForEach(corners,
    [&](vtkIdType c)
    {
      const Id corner = static_cast<Id>(c);
      const Id twin = mesh.Twins[corner];
      if (corner < twin)
      {
        WriteFace(atSides + 4 * static_cast<vtkIdType>(places.Sides[corner]), corner,
          mesh.Previous(corner), twin, mesh.Previous(twin));
      }
    });
}

}

template <typename Id>
StepOfNext<Id> MakeMidedgeStepOfNext()
{
  return { IsClosedDual<Id>, AppendRows<Id>, GetParents<Id>,
    [](const SurfaceLevel<Id>& level, IdsOut ids)
    { std::visit([&level](auto* to) { WriteFaces(level, to); }, ids); }, Count<Id>,
    MakeMidedgeStepsOfLater<Id>() };
}

SUBDIVISION_COMPILE_FUNCTION(MakeMidedgeStepOfNext);

}
