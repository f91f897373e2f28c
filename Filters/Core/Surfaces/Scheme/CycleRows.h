// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CycleRows.h
 * Rows of vertices for which walks are taken, several of which take turns.
 */
#ifndef SubdivisionObjects_CycleRows_h
#define SubdivisionObjects_CycleRows_h

#include "Core/Operators/RowBlock.h"
#include "Core/Surfaces/Mesh/CycleWalks.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <algorithm>
#include <array>

namespace subdivision
{

/// The vertex at the other end of the edge by which a walk enters a face.
template <typename Id>
Id GetNeighbour(const PolygonMesh<Id>& mesh, const FanStep<Id>& step)
{
  return mesh.Vertices[step.Forward ? mesh.Next(step.Corner) : mesh.Previous(step.Corner)];
}

/// Appends the rows of vertices [begin, end). wanted(v): takes a walk around v, which must have one
/// fan that is a cycle. regular(v, steps, columns) writes the columns of a vertex that has these
/// weights, or returns false; other(v, steps) then appends its entries. `steps`: of VisitCycle;
/// empty if the vertex was not wanted.
template <std::size_t N, typename Id, typename Wanted, typename Regular, typename Other>
void AppendCycleRows(const PolygonMesh<Id>& mesh, const std::array<double, N>& weights,
  vtkIdType begin, vtkIdType end, const Wanted& wanted, const Regular& regular, const Other& other,
  RowBlock<Id>& rows)
{
  if (begin >= end)
  {
    return;
  }
  CycleWalks<Id> walks;
  for (vtkIdType first = begin; first < end; first += walks.Most)
  {
    const vtkIdType last = std::min<vtkIdType>(end, first + walks.Most);
    walks.Walk(mesh, static_cast<Id>(first), static_cast<Id>(last), wanted);
    for (vtkIdType vertex = first; vertex < last; ++vertex)
    {
      vertex += rows.AddRun(weights, last - vertex,
        [&](vtkIdType i, Id* columns)
        {
          const Id v = static_cast<Id>(vertex + i);
          return regular(v, walks.Get(v), columns);
        });
      if (vertex < last)
      {
        other(static_cast<Id>(vertex), walks.Get(static_cast<Id>(vertex)));
        rows.EndRow();
      }
    }
  }
}

/// Appends the rows of vertices [begin, end). From `firstMade` on (-1: none) a step made them, and
/// find(v, columns) writes the row of a smooth one that needs no walk, or returns false; before,
/// regular(v, steps, columns) does as of AppendCycleRows. other(v, steps) appends the entries of
/// any other vertex, with the walk around it if it is smooth.
template <std::size_t N, typename Id, typename Regular, typename Find, typename Other>
void AppendVertexRows(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags,
  const std::array<double, N>& weights, vtkIdType firstMade, vtkIdType begin, vtkIdType end,
  const Regular& regular, const Find& find, const Other& other, RowBlock<Id>& rows)
{
  const auto isSmooth = [&tags](vtkIdType v) { return tags.Vertices[v] == VertexTag::Smooth; };
  const vtkIdType first = firstMade < 0 ? end : std::min(end, std::max(begin, firstMade));
  AppendCycleRows(mesh, weights, begin, first, isSmooth, regular, other, rows);
  AppendRegularGroups<1>(
    weights, first, end,
    [&](vtkIdType v, Id* columns) { return isSmooth(v) && find(static_cast<Id>(v), columns); },
    [&](vtkIdType v)
    {
      std::vector<FanStep<Id>> steps;
      if (isSmooth(v))
      {
        VisitCycle(
          mesh, mesh.VertexCorners[v], [&](const FanStep<Id>& step) { steps.push_back(step); });
      }
      other(static_cast<Id>(v), steps);
    },
    rows);
}

}

#endif
