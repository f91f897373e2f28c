// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpLimits.h
 * Limit positions and tangents where creases are still sharp for some steps.
 *
 * The steps in which they are sharp are done for a patch around the creases only. It is cropped to
 * the same vertices and what is around them after each, and so stays as small as it was. A limit
 * row of what comes out, times all these steps, is a row over the level's vertices.
 */
#ifndef SubdivisionObjects_SharpLimits_h
#define SubdivisionObjects_SharpLimits_h

#include "Core/Surfaces/Scheme/SharpRows.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace subdivision
{

/// Tags of some steps.
template <typename Id>
struct SharpTags
{
  int Until = 0; ///< the tags hold in steps before this one
  SharpTagPair<Id> Tags;
};

template <typename Id>
class SharpLimits
{
public:
  /// What is sharper is no sharper: the surface around a vertex is then 2^-52 of what it was. For
  /// tangents, which are differences of points so near, rounding errors are then as large.
  static constexpr int MostSteps = 52;
  static constexpr int MostStepsOfTangents = 26;

  /// Columns and weights.
  using LimitRow = std::vector<std::pair<Id, double>>;

  SharpLimits() = default;
  /// `edges`: pieces of the level's edges, ascending. `stages`: ascending.
  SharpLimits(const SurfaceLevel<Id>& level, const SurfaceScheme<Id>& scheme,
    const std::vector<SharpEdge<Id>>& edges, std::vector<SharpTags<Id>> stages);

  /// Goes through vertices [begin, end): own(row) for each that has a row of this, in between
  /// others(first, last).
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
  std::vector<Id> Vertices;      ///< ascending
  std::vector<LimitRow> Rows[3]; ///< of each kind
};

}

#endif
