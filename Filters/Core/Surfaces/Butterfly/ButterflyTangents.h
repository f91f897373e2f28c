// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyTangents.h
 * Tangents of modified Butterfly surfaces.
 *
 * A tangent is a left eigenvector, of eigenvalue 1/2, of the step around a vertex. Around regular
 * vertices it reaches two rings (the survey's figure 8), along curves two vertices; else one ring.
 * It is taken one level further on, where the rules around every vertex are those of all further
 * levels, and multiplied by the step.
 */
#ifndef SubdivisionObjects_ButterflyTangents_h
#define SubdivisionObjects_ButterflyTangents_h

#include "Core/Surfaces/Scheme/SurfaceRings.h"

namespace subdivision
{

template <typename Id>
class ButterflyTangents
{
public:
  ButterflyTangents(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, const SurfaceScheme<Id>& scheme)
    : Level(level)
    , Mesh(level.Mesh)
    , Tags(tags)
    , Scheme(scheme)
  {
  }

  /// Adds the entries of a vertex's row. A tangent that does not exist has none.
  void Append(Id vertex, LimitKind kind, RowBlock<Id>& rows);

private:
  /// Edges around the vertex or through its sector, and edge j across from face j.
  void CollectFaces(FanStep<Id> step, int size);
  /// The row of the next level's point on an edge, or of a vertex, which stays.
  void AddPoint(Id edge, double weight, RowBlock<Id>& rows);
  void AddAlongCurve(Id vertex, Id edge, double weight, RowBlock<Id>& rows);
  void AppendInside(Id vertex, LimitKind kind, RowBlock<Id>& rows);
  void AppendOnCurve(Id vertex, LimitKind kind, double turn, RowBlock<Id>& rows);
  void AppendAcrossRegularCurve(Id vertex, double turn, RowBlock<Id>& rows);
  void AppendAtCorner(
    Id vertex, LimitKind kind, const SectorEnds<Id>& ends, double turn, RowBlock<Id>& rows);

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const SurfaceScheme<Id>& Scheme;
  RowBlock<Id> Next;
  std::vector<Id> Edges;
  std::vector<Id> Across;
};

}

#endif
