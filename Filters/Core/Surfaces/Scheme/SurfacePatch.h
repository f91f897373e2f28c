// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfacePatch.h
 * Part of a level: what lies around some of its vertices, as a level of its own.
 */
#ifndef SubdivisionObjects_SurfacePatch_h
#define SubdivisionObjects_SurfacePatch_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <vector>

namespace subdivision
{

/// The faces that touch some vertices or their neighbours: these vertices are inside, and all rules
/// at them and at their edges are those of the whole level. The patch ends in corners and sharp
/// edges. It keeps the order of everything.
template <typename Id>
class SurfacePatch
{
public:
  /// `vertices`: ascending.
  SurfacePatch(const SurfaceLevel<Id>& whole, const std::vector<Id>& vertices);

  /// Tags of the whole level as tags of the patch.
  SurfaceTags<Id> CropTags(const SurfaceLevel<Id>& whole, const SurfaceTags<Id>& tags) const;

  /// Where something of the whole level is in the patch; -1: it is not there.
  static Id Find(const std::vector<Id>& ids, Id id);

  SurfaceLevel<Id> Level;   ///< with the tags of the whole level
  std::vector<Id> Vertices; ///< of the whole level, ascending
  std::vector<Id> Edges;
  std::vector<Id> Faces;

private:
  void Collect(const PolygonMesh<Id>& whole, const std::vector<Id>& vertices);
  void CropFaces(const PolygonMesh<Id>& whole);
  void CropEdges(const PolygonMesh<Id>& whole);
  void CropVertices(const PolygonMesh<Id>& whole);
  Id FindCorner(const PolygonMesh<Id>& whole, Id corner) const;

  std::vector<bool> IsInside; ///< of each vertex of the patch
};

}

#endif
