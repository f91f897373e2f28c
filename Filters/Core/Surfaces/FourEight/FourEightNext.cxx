// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightNext.h"

#include "Core/Memory/ForNumbered.h"
#include "Core/Memory/Ids.h"
#include "Core/Surfaces/FourEight/FourEightLater.h"
#include "Core/Surfaces/FourEight/FourEightRings.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

namespace subdivision
{
namespace
{

/// The vertices around that in a face are those of the face.
template <typename Id>
void AppendApices(
  const FourEightNextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const auto visitAround = [&next](Id first, Id size, const auto& visit)
  { std::for_each_n(next.Mesh.Vertices.data() + first, size, visit); };
  AppendVerticesInFaces(next, begin, end, visitAround, rows);
}

template <typename Id>
void AppendCentres(
  const FourEightNextLevel<Id>& next, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  Id corner = next.FindOwner(begin);
  rows.AddRun(FourEightCentre, end - begin,
    [&](vtkIdType, Id* columns)
    {
      corner = next.FindNextOwner(corner);
      const std::array<Id, 4> quad = next.GetVertices(corner++);
      std::copy(quad.begin(), quad.end(), columns);
      return true;
    });
}

/// Calls visit(face, quad, owner, side, other) for each face of the level after the next one, which
/// lies between two quads across a side of one of them: it belongs to that with the smaller number.
template <typename Id, typename Visit>
void ForSpokes(const FourEightNextLevel<Id>& next, const Visit& visit)
{
  const auto forSides = [&](vtkIdType c, const auto& act)
  {
    const Id owner = static_cast<Id>(c);
    if (!next.IsOwner(owner))
    {
      return;
    }
    const Id quad = next.GetQuad(owner);
    const std::array<Id, 4> others = next.GetNeighbours(owner);
    for (std::size_t side = 0; side < 4; ++side)
    {
      if (quad < others[side])
      {
        act(quad, owner, side, others[side]);
      }
    }
  };
  ForNumbered<Id>(
    next.Mesh.GetNumberOfCorners(), [&](vtkIdType corner, Id& face)
    { forSides(corner, [&face](Id, Id, std::size_t, Id) { ++face; }); },
    [&](vtkIdType corner, Id& face)
    {
      forSides(corner, [&](Id quad, Id owner, std::size_t side, Id other)
        { visit(face++, quad, owner, side, other); });
    });
}

template <typename Id>
SurfaceLevel<Id> Count(const SurfaceLevel<Id>& skipped)
{
  SurfaceLevel<Id> next;
  next.Step = skipped.Step + 1;
  next.Mesh.Arity = 4;
  next.Mesh.NumberOfVertices = skipped.Mesh.NumberOfVertices + skipped.Mesh.NumberOfFaces;
  next.Mesh.NumberOfFaces = skipped.Mesh.GetNumberOfEdges();
  next.Mesh.EdgesNotStored = 2 * next.Mesh.NumberOfFaces;
  return next;
}

template <typename Id>
void AppendRows(const SurfaceLevel<Id>& level, const IrregularRows<Id>&, vtkIdType begin,
  vtkIdType end, RowBlock<Id>& rows)
{
  const FourEightNextLevel<Id> next(level);
  ForKindsOfRows<2>({ next.GetNumberOfVertices(), next.GetNumberOfFaces() }, begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      kind == 0 ? AppendFourEightVertices(level, first, last, rows)
                : AppendCentres(next, first, last, rows);
    });
}

template <typename Id>
void GetParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents)
{
  const FourEightNextLevel<Id> next(level);
  const vtkIdType quad = row - next.GetNumberOfVertices();
  if (quad < 0)
  {
    parents.assign({ row });
    return;
  }
  const std::array<Id, 4> vertices = next.GetVertices(next.FindOwner(quad));
  parents.assign(vertices.begin(), vertices.end());
}

template <typename Id, typename Out>
void WriteFaces(const SurfaceLevel<Id>& level, Out* ids)
{
  const FourEightNextLevel<Id> next(level);
  const Id centres = static_cast<Id>(next.GetNumberOfVertices());
  ForSpokes(next,
    [&](Id face, Id quad, Id owner, std::size_t side, Id other)
    {
      const std::array<Id, 4> vertices = next.GetVertices(owner);
      WriteFace(ids + 4 * static_cast<vtkIdType>(face), vertices[side], centres + other,
        vertices[(side + 1) % 4], centres + quad);
    });
}

}

template <typename Id>
void AppendFourEightVertices(
  const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const FourEightNextLevel<Id> next(level);
  const FourEightMadeVertices<Id> made(level);
  // On the next level those around a vertex are in the faces of this one.
  const auto ring = [&next](Id corner) { return next.GetApex(corner); };
  const vtkIdType others = made.GetFirst();
  ForKindsOfRows<3>({ others, level.Mesh.NumberOfVertices - others, level.Mesh.NumberOfFaces },
    begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      kind == 0     ? AppendWalkedVertices(next, first, last, ring, rows)
        : kind == 1 ? made.Append(first, last, ring, rows)
                    : AppendApices(next, first, last, rows);
    });
}

template <typename Id>
StepOfNext<Id> MakeFourEightStepOfNext()
{
  return { [](const SurfaceLevel<Id>& level) { return !FourEightTopology<Id>(level).HasFixed(); },
    AppendRows<Id>, GetParents<Id>, [](const SurfaceLevel<Id>& level, IdsOut ids)
    { std::visit([&level](auto* to) { WriteFaces(level, to); }, ids); }, Count<Id>,
    MakeFourEightStepsOfLater<Id>(), true };
}

SUBDIVISION_COMPILE_FUNCTION(AppendFourEightVertices);
SUBDIVISION_COMPILE_FUNCTION(MakeFourEightStepOfNext);

}
