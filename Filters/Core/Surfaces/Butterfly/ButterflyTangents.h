// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyTangents.h
 * Tangents of modified Butterfly surfaces.
 *
 * A tangent is a left eigenvector for the eigenvalue 1/2 of the step around a vertex. At regular
 * vertices it has weights for all vertices within two edges (figure 8 of Zorin's survey), along
 * curves for two vertices on each side, otherwise for the neighbours. It is taken on the next
 * level, from which on the rules around each vertex stay the same, and multiplied by the rows of
 * this step.
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
  /// Collects the edges around the vertex or in its sector, and in Across for each face there its
  /// edge opposite to the vertex.
  void CollectFaces(FanStep<Id> step, int size);
  /// Adds the row of the edge point of an edge, times a weight.
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
