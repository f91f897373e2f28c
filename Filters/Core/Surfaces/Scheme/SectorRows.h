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

/// The points towards which one new point moves.
template <typename Id>
struct FlatPoints
{
  std::vector<FlatPoint<Id>> Points;

  void Add(const FlatPoint<Id>& point)
  {
    if (point.Flatness > 0.)
    {
      this->Points.push_back(point);
    }
  }
  double GetSize() const { return static_cast<double>(this->Points.size()); }
  /// The weight of the point before it moves.
  double GetKept() const
  {
    double kept = 1.;
    for (const FlatPoint<Id>& point : this->Points)
    {
      kept -= point.Flatness / this->GetSize();
    }
    return kept;
  }
  void Append(RowBlock<Id>& rows) const
  {
    for (const FlatPoint<Id>& point : this->Points)
    {
      point.Append(rows, point.Flatness / this->GetSize());
    }
  }
};

/// The rule of a smooth edge of which ends lie on curves or corners: the mean of the masks of these
/// ends (Mathematics 12).
template <typename Id>
struct EdgeAtCurve
{
  double Weights[2] = { 0., 0. }; ///< of the ends of the edge: sums of their masks
  int Size = 0;                   ///< how many these are
  FlatPoints<Id> Flat;

  /// weigh(angle) returns the weights of the end itself and of the other one by the angle of one
  /// face, 0 for the plain rule, which always holds without `modified`.
  template <typename Weigh>
  EdgeAtCurve(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id edge, bool modified,
    const Weigh& weigh)
  {
    for (int end = 0; end < 2; ++end)
    {
      const Id vertex = mesh.EdgeVertices[2 * edge + end];
      if (tags.Vertices[vertex] != VertexTag::Curve && tags.Vertices[vertex] != VertexTag::Corner)
      {
        continue;
      }
      const Id at = GetCornerAt(mesh, mesh.EdgeCorners[edge], vertex);
      const auto [own, far] = weigh(modified ? FindAngleOfFace(mesh, tags, vertex, at) : 0.);
      this->Weights[end] += own;
      this->Weights[1 - end] += far;
      ++this->Size;
      if (modified)
      {
        this->Flat.Add(FindFlatPoint(mesh, tags, vertex, at, edge, false));
      }
    }
  }
};

}

#endif
