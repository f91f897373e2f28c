// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpRows.h
 * Steps in which some edges are still sharp: rows between those of the sharp and of the smooth
 * rules.
 *
 * An edge of sharpness s is a crease like any other for floor(s) steps, and so are its ends, its
 * crossings and all that lies near. In the step after these it is one in part, s - floor(s): rows
 * lie between those without and those with all such edges, near several by the mean of their parts.
 */
#ifndef SubdivisionObjects_SharpRows_h
#define SubdivisionObjects_SharpRows_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <vector>

namespace subdivision
{

/// A piece of a semi-sharp crease, and for how many steps it is still sharp.
template <typename Id>
struct SharpEdge
{
  Id Edge;
  double Left;
};

/// Tags of a step: with all edges sharp that are for the whole of it, and with those too that are
/// only in part.
template <typename Id>
struct SharpTagPair
{
  SurfaceTags<Id> Whole;
  SurfaceTags<Id> All;
};

template <typename Id>
class SharpRows
{
public:
  /// `edges`: those that are still sharp, which ascend.
  SharpRows(const SurfaceLevel<Id>& level, SharpTagPair<Id>&& tags,
    const std::vector<SharpEdge<Id>>& edges);

  /// Rows [begin, end) of the step from the level.
  void Append(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const;

private:
  struct WeightedRow
  {
    vtkIdType Row;
    double Part; ///< of the tags with all edges
  };
  void AddVertices(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges);
  void AddEdges(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges);
  void AddFaces(const PolygonMesh<Id>& mesh);
  double GetPart(const std::vector<Id>& vertices) const;
  std::vector<Id> CollectFaces(const PolygonMesh<Id>& mesh, Id vertex) const;

  SharpTagPair<Id> Tags;
  std::vector<WeightedRow> Rows;  ///< ascending
  std::vector<WeightedRow> Parts; ///< of vertices at edges that are sharp in part, ascending
};

/// The vertices and all that share a face or an edge with one of them; both ascending.
template <typename Id>
std::vector<Id> CollectWithNeighbours(const PolygonMesh<Id>& mesh, const std::vector<Id>& vertices);

}

#endif
