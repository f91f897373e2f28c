// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopRegular.h
 * Loop's rows where the surface is smooth, with six neighbours or others.
 */
#ifndef SubdivisionObjects_LoopRegular_h
#define SubdivisionObjects_LoopRegular_h

#include "Core/Rules/Masks.h"
#include "Core/Surfaces/Mesh/CycleWalks.h"
#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <array>

namespace subdivision
{

/// The masks of a smooth vertex with six neighbours, and of a smooth edge inside.
inline constexpr std::array<double, 7> LoopVertex{ 5. / 8., 3. / (8. * 6.), 3. / (8. * 6.),
  3. / (8. * 6.), 3. / (8. * 6.), 3. / (8. * 6.), 3. / (8. * 6.) };
inline constexpr std::array<double, 4> LoopEdge{ 3. / 8., 3. / 8., 1. / 8., 1. / 8. };

/// Appends the entries of a vertex with a ring of any size.
template <typename Id>
void AppendLoopRing(
  Id vertex, Rule rule, LoopWeights weights, const std::vector<Id>& ring, RowBlock<Id>& rows)
{
  const Mask mask = VertexMask(rule, static_cast<vtkIdType>(ring.size()), weights);
  rows.Add(vertex, mask.Own);
  for (Id member : ring)
  {
    rows.Add(member, mask.Ring);
  }
}

/// Appends the entries of a smooth vertex, for which it takes a walk. `neighbour(step)`: the vertex
/// at the edge by which a walk enters a face.
template <typename Id, typename Neighbour>
void AppendLoopVertex(const PolygonMesh<Id>& mesh, Id vertex, LoopWeights weights,
  const Neighbour& neighbour, RowBlock<Id>& rows)
{
  std::vector<Id> ring;
  VisitCycle(mesh, mesh.VertexCorners[vertex],
    [&](const FanStep<Id>& step) { ring.push_back(neighbour(step)); });
  AppendLoopRing(vertex, Rule::Surface, weights, ring, rows);
}

/// Appends the rows of vertices, for which it takes walks together. other(v) appends the entries of
/// one that is not smooth.
template <typename Id, typename Neighbour, typename Other>
void AppendLoopVertices(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
  LoopWeights weights, vtkIdType begin, vtkIdType end, const Neighbour& neighbour,
  const Other& other, RowBlock<Id>& rows)
{
  if (begin >= end)
  {
    return;
  }
  const auto isSmooth = [&](vtkIdType v) { return tags.Vertices[v] == VertexTag::Smooth; };
  CycleWalks<Id> walks;
  std::vector<Id> ring;
  for (vtkIdType first = begin; first < end; first += walks.Most)
  {
    const vtkIdType last = std::min<vtkIdType>(end, first + walks.Most);
    walks.Walk(level.Mesh, static_cast<Id>(first), static_cast<Id>(last), isSmooth);
    for (vtkIdType vertex = first; vertex < last; ++vertex)
    {
      vertex += rows.AddRun(LoopVertex, last - vertex,
        [&](vtkIdType i, Id* columns)
        {
          columns[0] = static_cast<Id>(vertex + i);
          const auto& steps = walks.Get(columns[0]);
          const bool isRegular = steps.size() == 6;
          for (std::size_t k = 0; isRegular && k < 6; ++k)
          {
            columns[k + 1] = neighbour(steps[k]);
          }
          return isRegular;
        });
      if (vertex == last)
      {
        break;
      }
      const Id v = static_cast<Id>(vertex);
      if (isSmooth(v))
      {
        ring.clear();
        for (const FanStep<Id>& step : walks.Get(v))
        {
          ring.push_back(neighbour(step));
        }
        AppendLoopRing(v, Rule::Surface, weights, ring, rows);
      }
      else
      {
        other(v);
      }
      rows.EndRow();
    }
  }
}

}

#endif
