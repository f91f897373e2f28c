// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurveTangents.h
 * Tangents of vertices on curves and of corners in all schemes but Butterfly and the dual ones.
 */
#ifndef SubdivisionObjects_CurveTangents_h
#define SubdivisionObjects_CurveTangents_h

#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <cmath>

namespace subdivision
{

/// Appends a tangent of a vertex on a curve or of a corner, in the sector of `given`, or, if that
/// is -1, of FindTangentCorner: along the curve and across it; at a corner along the first sharp
/// edge of the sector, and perpendicular to it in the plane of both. There is none across a sector
/// that ends at a Blend edge. `ring` gets the other ends of the sector's edges. `across(ends,
/// turn)` appends the tangent across a curve, times `turn`.
template <typename Id, typename Across>
void AppendSectorTangent(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, Id vertex,
  LimitKind kind, std::vector<Id>& ring, RowBlock<Id>& rows, const Across& across, Id given = -1)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const bool isCurve = IsOnCurve(mesh, tags, vertex);
  const Id corner = given < 0 ? FindTangentCorner(mesh, tags, vertex) : given;
  const SectorEnds<Id> ends = corner < 0 ? SectorEnds<Id>() : FindSectorEnds(mesh, tags, corner);
  const auto isSharp = [&](Id halfEdge) { return IsSharp(tags.Edges[mesh.Edges[halfEdge]]); };
  if (ends.Size == 0 || !isSharp(ends.First.GetHalfEdgeIn(mesh)) ||
    !isSharp(ends.Last.GetHalfEdgeOut(mesh)))
  {
    CollectCurveEdges(mesh, tags, vertex, ring);
    if (isCurve && kind == LimitKind::Tangent1 && ring.size() == 2)
    {
      rows.Add(mesh.GetOtherEnd(ring[0], vertex), 1.);
      rows.Add(mesh.GetOtherEnd(ring[1], vertex), -1.);
    }
    return;
  }
  ring.clear();
  FanStep<Id> step = ends.First;
  for (int i = 0; i < ends.Size; ++i)
  {
    ring.push_back(mesh.GetOtherEnd(mesh.Edges[step.GetHalfEdgeIn(mesh)], vertex));
    step.Advance(mesh);
  }
  ring.push_back(mesh.GetOtherEnd(mesh.Edges[ends.Last.GetHalfEdgeOut(mesh)], vertex));
  const double turn = ends.First.Forward ? 1. : -1.;
  if (kind == LimitKind::Tangent1)
  {
    rows.Add(ring.front(), 1.);
    rows.Add(isCurve ? ring.back() : vertex, -1.);
    return;
  }
  if (isCurve)
  {
    across(ends, turn);
    return;
  }
  const Sector<Id>* sector =
    given < 0 ? FindFirstSector(tags, vertex) : FindSector(tags, vertex, ends);
  const double angle = sector ? sector->Angle : Pi / 2.;
  const double first = -turn * std::cos(angle) / std::sin(angle);
  const double last = turn / std::sin(angle);
  rows.Add(ring.front(), first);
  rows.Add(ring.back(), last);
  rows.Add(vertex, -first - last);
}

}

#endif
