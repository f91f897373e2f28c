// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpLimits.h
 * Limit positions and tangents of vertices near creases that are still sharp for some steps.
 *
 * These steps are made for a patch around the creases only (SharpPatch.h). After each step the
 * patch is cropped to the surroundings of the same vertices, so that it does not grow. A limit row
 * on the last patch times the operators of all these steps is a row over the vertices of the level.
 */
#ifndef SubdivisionObjects_SharpLimits_h
#define SubdivisionObjects_SharpLimits_h

#include "Core/Surfaces/Scheme/SharpPatch.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace subdivision
{

/// The vertices whose limits depend on sharp edges, ascending: the ends of these edges, their
/// neighbours, because the rules of edges and faces there depend on them, and the neighbours of
/// these, because of tangents.
template <typename Id>
std::vector<Id> CollectNear(const PolygonMesh<Id>& mesh, const std::vector<SharpEdge<Id>>& edges);

template <typename Id>
class SharpLimits
{
public:
  /// Larger sharpness counts as this number of steps: the neighbourhood of a vertex is then 2^-52
  /// of its first size. Tangents are differences of points as near as this, so that for them
  /// rounding errors allow half as many steps only.
  static constexpr int MostSteps = 52;
  static constexpr int MostStepsOfTangents = 26;

  /// Columns and weights.
  using RowEntries = std::vector<std::pair<Id, double>>;

  SharpLimits() = default;
  /// `creases`: of the level.
  SharpLimits(const SurfaceLevel<Id>& level, const SurfaceScheme<Id>& scheme,
    const SharpCreases<Id>& creases);

  /// Goes through vertices [begin, end): calls own(row) for each vertex that has a row in this
  /// object, and others(first, last) for the ranges between.
  template <typename Others, typename Own>
  void ForEachOther(vtkIdType begin, vtkIdType end, const Others& others, const Own& own) const
  {
    auto at = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), begin);
    for (; at != this->Vertices.end() && end > *at; ++at)
    {
      others(begin, *at);
      own(at - this->Vertices.begin());
      begin = *at + 1;
    }
    others(begin, end);
  }
  void Append(vtkIdType row, LimitKind kind, RowBlock<Id>& rows) const;

private:
  std::vector<Id> Vertices;        ///< ascending
  std::vector<RowEntries> Rows[3]; ///< of each kind
};

}

#endif
