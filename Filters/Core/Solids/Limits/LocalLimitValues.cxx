// SPDX-License-Identifier: BSD-3-Clause
// Values and normals by the steps of a LocalLimit.
#include "Core/Solids/Limits/LocalLimit.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace subdivision
{

/// How many values the even levels, and how many the odd levels have at most. Levels of one kind
/// use the same memory, as no two of them are needed at a time.
template <typename Id>
std::array<vtkIdType, 2> LocalLimit<Id>::GetSizesBetween() const
{
  std::array<vtkIdType, 2> sizes{ { 0, 0 } };
  for (std::size_t l = 0; l < this->Steps.size(); ++l)
  {
    sizes[l % 2] = std::max(sizes[l % 2], this->Steps[l].Rows.GetNumberOfRows());
  }
  return sizes;
}

template <typename Id>
vtkIdType LocalLimit<Id>::GetNumberBetween() const
{
  const auto sizes = this->GetSizesBetween();
  return sizes[0] + sizes[1];
}

template <typename Id>
void LocalLimit<Id>::ForEachBlock(const User& use) const
{
  const vtkIdType starts[2] = { 0, this->GetSizesBetween()[0] };
  for (std::size_t l = 0; l < this->Steps.size(); ++l)
  {
    const Step& step = this->Steps[l];
    ForBlocksInThreads(step.Rows.GetNumberOfRows(),
      [&](vtkIdType begin, vtkIdType end)
      {
        WeightedRows<Id> rows = step.Rows.GetRows(begin, end);
        rows.FirstRow += starts[l % 2];
        rows.ToBetween = true;
        rows.FromBetween = l > 0;
        rows.FirstColumn = l == 0 ? 0 : starts[(l - 1) % 2];
        use(rows);
      });
    ForBlocksInThreads(step.Limits.GetNumberOfRows(),
      [&](vtkIdType begin, vtkIdType end)
      {
        WeightedRows<Id> rows = step.Limits.GetRows(begin, end);
        rows.Numbers = step.Vertices.data() + begin;
        rows.FromBetween = true;
        rows.FirstColumn = starts[l % 2];
        use(rows);
      });
  }
}

template <typename Id>
void LocalLimit<Id>::ComputeNormals(const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned,
  double* normals) const
{
  Buffer<double> values;
  const double* before = points;
  for (const Step& step : this->Steps)
  {
    Buffer<double> next(3 * step.Rows.GetNumberOfRows());
    step.Rows.Apply(before, next.data(), 3);
    values = std::move(next);
    before = values.data();
    const auto size = static_cast<vtkIdType>(step.Vertices.size());
    Buffer<double> own(3 * size);
    ComputeLimitNormals(step.Tangents, { before, points.Tie }, inverted, turned, own.data());
    ForEach(size, [&](vtkIdType i)
      { std::copy_n(own.data() + 3 * i, 3, normals + 3 * vtkIdType(step.Vertices[i])); });
  }
}

SUBDIVISION_COMPILE(class LocalLimit);

}
