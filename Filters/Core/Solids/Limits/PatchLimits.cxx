// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/PatchLimits.h"

#include "Core/Solids/AllSchemes/VolumeSchemes.h"

#include <algorithm>

namespace subdivision
{

template <typename LevelType>
bool PatchLimits<LevelType>::Start(const PatchSimplex<Id>& simplex, PatchTree& tree) const
{
  const int size = simplex.Corners[1] < 0 ? 1 : simplex.Corners[2] < 0 ? 2 : 3;
  if (size == 1)
  {
    return false;
  }
  const auto isBefore = [this](Id a, Id b)
  { return AreValuesBefore(this->Values, this->Components, a, b); };
  const std::array<int, 3> order = SortCorners(
    size, [&](int a, int b) { return isBefore(simplex.Corners[a], simplex.Corners[b]); });
  std::array<Id, 3> corners{ { -1, -1, -1 } };
  for (int k = 0; k < size; ++k)
  {
    corners[k] = simplex.Corners[order[k]];
  }
  SheetPatch<Id> patch;
  if (!(size == 3 ? this->Reader.ReadFace(simplex.Number, corners, patch)
                  : this->Reader.ReadEdge(simplex.Number, corners[0], corners[1], isBefore, patch)))
  {
    return false;
  }
  double* values = tree.Start(patch.Key, patch.Columns.size(), order);
  for (const Id column : patch.Columns)
  {
    values = std::copy_n(this->At(column), this->Components, values);
  }
  return true;
}

template <typename LevelType>
bool PatchLimits<LevelType>::FindAtVertex(Id vertex, SheetRows& rows, double* limit) const
{
  SheetPatch<Id> patch;
  if (!this->Reader.ReadVertex(vertex, patch))
  {
    return false;
  }
  const std::vector<double>& weights = rows.Find(patch.Key);
  std::fill_n(limit, this->Components, 0.);
  for (std::size_t k = 0; k < patch.Columns.size(); ++k)
  {
    const double* value = this->At(patch.Columns[k]);
    for (int c = 0; weights[k] != 0. && c < this->Components; ++c)
    {
      limit[c] += weights[k] * value[c];
    }
  }
  return true;
}

template class PatchLimits<Level<int>>;
template class PatchLimits<Level<long long>>;
template class PatchLimits<TetOctLevel<int>>;
template class PatchLimits<TetOctLevel<long long>>;

}
