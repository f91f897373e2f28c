// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveRows.h
 * The rows of vertices on curves and of corners in Loop and Catmull-Clark.
 */
#ifndef SubdivisionObjects_CurveRows_h
#define SubdivisionObjects_CurveRows_h

#include "Core/Surfaces/Scheme/SurfaceRings.h"

namespace subdivision
{

/// Appends the row of a vertex that is not smooth. On a curve it follows a cubic B-spline along its
/// two sharp edges, with the weight `own` for the vertex itself; otherwise the vertex stays.
template <typename Id>
void AppendCurveVertex(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex,
  double own, std::vector<Id>& edges, RowBlock<Id>& rows)
{
  edges.clear();
  if (tags.Vertices[vertex] == VertexTag::Curve)
  {
    CollectCurveEdges(mesh, tags, vertex, edges);
  }
  if (edges.size() != 2)
  {
    rows.Add(vertex, 1.);
    return;
  }
  rows.Add(vertex, own);
  rows.Add(mesh.GetOtherEnd(edges[0], vertex), (1. - own) / 2.);
  rows.Add(mesh.GetOtherEnd(edges[1], vertex), (1. - own) / 2.);
}

}

#endif
