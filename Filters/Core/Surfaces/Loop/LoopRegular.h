// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopRegular.h
 * Loop's rows where the surface is smooth, with six neighbours or others.
 */
#ifndef SubdivisionObjects_LoopRegular_h
#define SubdivisionObjects_LoopRegular_h

#include "Core/Rules/Masks.h"
#include "Core/Surfaces/Scheme/CycleRows.h"
#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <algorithm>
#include <array>
#include <iterator>

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
  const auto isSmooth = [&](vtkIdType v) { return tags.Vertices[v] == VertexTag::Smooth; };
  using Steps = std::vector<FanStep<Id>>;
  std::vector<Id> ring;
  AppendCycleRows(
    level.Mesh, LoopVertex, begin, end, isSmooth,
    [&](Id vertex, const Steps& steps, Id* columns)
    {
      *columns++ = vertex;
      const bool isRegular = steps.size() == 6;
      for (std::size_t k = 0; isRegular && k < 6; ++k)
      {
        *columns++ = neighbour(steps[k]);
      }
      return isRegular;
    },
    [&](Id vertex, const Steps& steps)
    {
      if (!isSmooth(vertex))
      {
        other(vertex);
        return;
      }
      ring.clear();
      std::transform(steps.begin(), steps.end(), std::back_inserter(ring), neighbour);
      AppendLoopRing(vertex, Rule::Surface, weights, ring, rows);
    },
    rows);
}

}

#endif
