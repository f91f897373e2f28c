// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyRegular.h
 * Rows of the modified Butterfly scheme between vertices that have smooth edges all around.
 */
#ifndef SubdivisionObjects_ButterflyRegular_h
#define SubdivisionObjects_ButterflyRegular_h

#include "Core/Operators/RowBlock.h"
#include "Core/Surfaces/Butterfly/ButterflyMasks.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <array>
#include <vector>

namespace subdivision
{

/// The mask of an edge between two vertices of six faces: its ends, and on each side the vertex
/// opposite and the two beyond.
inline constexpr std::array<double, 8> ButterflyEdge{ 1. / 2., 1. / 2., 1. / 8., -1. / 16.,
  -1. / 16., 1. / 8., -1. / 16., -1. / 16. };

/// Appends the entries of an edge from an end with another number of faces all around, of which
/// `corner` is the end's in the first face of the edge. `neighbour(edge)`: the vertex at the other
/// end of an edge there.
template <typename Id, typename Neighbour>
void AppendButterflyRing(const PolygonMesh<Id>& mesh, Id edge, Id vertex, Id corner, double factor,
  const Neighbour& neighbour, RowBlock<Id>& rows)
{
  thread_local std::vector<Id> ring; // it begins with the edge's other end
  ring.clear();
  FanStep<Id> step{ corner, mesh.Edges[corner] == edge };
  do
  {
    ring.push_back(neighbour(mesh.Edges[step.GetHalfEdgeIn(mesh)]));
  } while (step.Advance(mesh) && step.Corner != corner);
  const int k = static_cast<int>(ring.size());
  // The weights depend on k only; they are stored for further edges with the same k.
  thread_local std::vector<double> weights;
  if (static_cast<int>(weights.size()) != k)
  {
    weights.resize(k);
    for (int j = 0; j < k; ++j)
    {
      weights[j] = butterfly::Ring(k, j);
    }
  }
  rows.Add(vertex, factor * butterfly::Centre);
  for (int j = 0; j < k; ++j)
  {
    rows.Add(ring[j], factor * weights[j]);
  }
}

}

#endif
