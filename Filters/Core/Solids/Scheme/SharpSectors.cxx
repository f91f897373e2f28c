// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/SharpSectors.h"

#include "Core/Memory/Ids.h"

#include <iterator>

namespace subdivision
{

template <typename Id>
void AddSharpSectors(const std::vector<Id>& smooth, const std::vector<Id>& sharp,
  const Buffer<Id>& edgeVertices, vtkIdType vertices, std::vector<SharpRow>& rows)
{
  std::vector<Id> both;
  std::set_union(
    smooth.begin(), smooth.end(), sharp.begin(), sharp.end(), std::back_inserter(both));
  const auto isBefore = [](const SharpRow& a, const SharpRow& b) { return a.Row < b.Row; };
  const auto size = static_cast<std::ptrdiff_t>(rows.size());
  const auto find = [&](vtkIdType row)
  {
    const auto end = rows.begin() + size;
    const auto found = std::lower_bound(rows.begin(), end, SharpRow{ row, 0. }, isBefore);
    return found != end && found->Row == row ? found->Sharpness : 0.;
  };
  for (const Id row : both)
  {
    const Id* ends = edgeVertices.data() + 2 * (row - vertices);
    const double mean = find(row) > 0. ? 0. : GetMeanOfEnds(ends, find);
    if (mean > 0.)
    {
      rows.push_back({ row, mean });
    }
  }
  std::inplace_merge(rows.begin(), rows.begin() + size, rows.end(), isBefore);
}

SUBDIVISION_COMPILE_FUNCTION(AddSharpSectors);

}
