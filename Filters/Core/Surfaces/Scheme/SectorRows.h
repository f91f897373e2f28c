// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SectorRows.h
 * The flatness of corners (Mathematics 12): in a sector of a corner, new points move towards the
 * plane of its two sharp edges.
 */
#ifndef SubdivisionObjects_SectorRows_h
#define SubdivisionObjects_SectorRows_h

#include "Core/Rules/SectorMasks.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <cmath>

namespace subdivision
{

/// The point of the plane towards which a new point moves, and how far it moves (Flatness). Weights
/// belong to the other ends of the two sharp edges; the corner itself has the rest.
template <typename Id>
struct FlatPoint
{
  double Flatness = 0.; ///< s; 0: there is no modification
  Id Corner = 0;
  Id Ends[2] = { 0, 0 };
  double Weights[2] = { 0., 0. };

  void Append(RowBlock<Id>& rows, double factor) const
  {
    rows.Add(this->Corner, factor * (1. - this->Weights[0] - this->Weights[1]));
    rows.Add(this->Ends[0], factor * this->Weights[0]);
    rows.Add(this->Ends[1], factor * this->Weights[1]);
  }
};

/// Finds the FlatPoint of the new point on `edge` or, if `isFace`, of the new point in the face of
/// `corner`. `corner` is a corner at `vertex`, and `edge` ends at `vertex`.
template <typename Id>
FlatPoint<Id> FindFlatPoint(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex,
  Id corner, Id edge, bool isFace)
{
  FlatPoint<Id> flat;
  if (tags.Vertices[vertex] != VertexTag::Corner || tags.Sectors.empty())
  {
    return flat;
  }
  const SectorEnds<Id> ends = FindSectorEnds(mesh, tags, corner);
  const Sector<Id>* sector = ends.Size > 0 ? FindSector(tags, vertex, ends) : nullptr;
  if (!sector || !(sector->Flatness > 0.))
  {
    return flat;
  }
  int j = 0;
  FanStep<Id> step = ends.First;
  while (isFace ? step.Corner != corner : mesh.Edges[step.GetHalfEdgeIn(mesh)] != edge)
  {
    if (++j > ends.Size)
    {
      return flat; // it belongs to another sector
    }
    step.Advance(mesh);
  }
  const double t = sector->Angle / ends.Size;
  const double c = isFace ? std::cos(j * t) + std::cos((j + 1) * t) : std::cos(j * t);
  const double s = isFace ? std::sin(j * t) + std::sin((j + 1) * t) : std::sin(j * t);
  const FlatWeights weights = GetFlatWeights(sector->Angle, c, s);
  flat.Weights[0] = weights.First;
  flat.Weights[1] = weights.Last;
  flat.Flatness = sector->Flatness;
  flat.Corner = vertex;
  flat.Ends[0] = mesh.GetOtherEnd(mesh.Edges[ends.First.GetHalfEdgeIn(mesh)], vertex);
  flat.Ends[1] = mesh.GetOtherEnd(mesh.Edges[ends.Last.GetHalfEdgeOut(mesh)], vertex);
  return flat;
}

}

#endif
