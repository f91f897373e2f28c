// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfacePatch.h
 * Copies the part of a level around some vertices as a level of its own.
 */
#ifndef SubdivisionObjects_SurfacePatch_h
#define SubdivisionObjects_SurfacePatch_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <vector>

namespace subdivision
{

/// The given vertices and all vertices that share an edge or a face with one of them are *inside*;
/// the patch has all edges and faces at inside vertices. Inside vertices and their edges have the
/// rules of the whole level. All other vertices of the patch become corners, and all other edges
/// sharp. Vertices, edges and faces keep their order.
template <typename Id>
class SurfacePatch
{
public:
  /// `vertices`: ascending.
  SurfacePatch(const SurfaceLevel<Id>& whole, const std::vector<Id>& vertices);

  /// Tags of the whole level as tags of the patch. Corners of sectors that are none of this level,
  /// which some schemes leave after a step, become -1.
  SurfaceTags<Id> CropTags(const SurfaceLevel<Id>& whole, const SurfaceTags<Id>& tags) const;

  /// The position of an id in one of the lists below, that is, its number in the patch; -1 if it is
  /// not there.
  static Id Find(const std::vector<Id>& ids, Id id);
  /// The same for a corner.
  Id FindCorner(const PolygonMesh<Id>& whole, Id corner) const;

  SurfaceLevel<Id> Level;   ///< with the tags of the whole level
  std::vector<Id> Vertices; ///< of the whole level, ascending
  std::vector<Id> Edges;
  std::vector<Id> Faces;

private:
  void Collect(const PolygonMesh<Id>& whole, const std::vector<Id>& vertices);
  void CropFaces(const PolygonMesh<Id>& whole);
  void CropEdges(const PolygonMesh<Id>& whole);
  void CropVertices(const PolygonMesh<Id>& whole);

  std::vector<bool> IsInside; ///< of each vertex of the patch
};

}

#endif
