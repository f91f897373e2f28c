// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpRows.h
 * The rows of a step in which semi-sharp creases are still sharp (Mathematics 12, Sharpness).
 *
 * An edge of sharpness s is a flagged crease for floor(s) steps, with all rules at and near it. In
 * the next step it is sharp in part, s - floor(s): rows near it are blends of the rows without and
 * with the creases that are sharp in part. Near several such edges the weight is the mean of their
 * parts.
 */
#ifndef SubdivisionObjects_SharpRows_h
#define SubdivisionObjects_SharpRows_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <vector>

namespace subdivision
{

/// An edge of a semi-sharp crease and its remaining sharpness.
template <typename Id>
struct SharpEdge
{
  Id Edge;
  double Left;
};

/// The two sets of tags of a step: `Whole` has as creases the edges that are sharp for the whole
/// step, `All` also the edges that are sharp in part.
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
  /// `edges`: that are still sharp, ascending.
  SharpRows(const SurfaceLevel<Id>& level, SharpTagPair<Id>&& tags,
    const std::vector<SharpEdge<Id>>& edges);

  /// Rows [begin, end) of the step from the level.
  void Append(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const;

private:
  struct PartlySharpRow
  {
    vtkIdType Row;
    double Part; ///< weight of the row with the tags `All`
  };
  void AddVertices(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges);
  void AddEdges(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges);
  void AddFaces(const PolygonMesh<Id>& mesh);
  double GetPart(const std::vector<Id>& vertices) const;

  SharpTagPair<Id> Tags;
  std::vector<PartlySharpRow> Rows;  ///< ascending
  std::vector<PartlySharpRow> Parts; ///< of vertices at edges that are sharp in part, ascending
};

/// The ends of edges, ascending.
template <typename Id>
std::vector<Id> CollectEnds(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges);

/// The vertices and all that share a face or an edge with one of them; both ascending.
template <typename Id>
std::vector<Id> CollectWithNeighbours(const PolygonMesh<Id>& mesh, const std::vector<Id>& vertices);

}

#endif
