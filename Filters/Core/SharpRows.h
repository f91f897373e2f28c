// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpRows.h
 * Steps in which some edges are still sharp: rows between those of the sharp and of the smooth
 * rules.
 */
#ifndef SubdivisionObjects_SharpRows_h
#define SubdivisionObjects_SharpRows_h

#include "SurfaceScheme.h"

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

template <typename Id>
class SharpRows
{
public:
  /// `tags`: with those `edges`, which ascend, sharp.
  SharpRows(
    const PolygonMesh<Id>& mesh, SurfaceTags<Id>&& tags, const std::vector<SharpEdge<Id>>& edges);

  /// Rows [begin, end) of the step from the level.
  void Append(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const;

  const SurfaceTags<Id>& GetTags() const { return this->Tags; }

private:
  struct WeightedRow
  {
    vtkIdType Row;
    double Sharpness;
  };
  static void Merge(std::vector<WeightedRow>& given, std::vector<WeightedRow>& rows);
  void AddSmoothEdges(const PolygonMesh<Id>& mesh, std::vector<WeightedRow>& rows) const;

  SurfaceTags<Id> Tags;
  std::vector<WeightedRow> Rows; ///< ascending
};

}

#endif
