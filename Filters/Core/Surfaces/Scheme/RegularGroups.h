// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularGroups.h
 * Rows of equal weights, some of which are made together, from vertices around an edge or face.
 */
#ifndef SubdivisionObjects_RegularGroups_h
#define SubdivisionObjects_RegularGroups_h

#include "Core/Operators/RowBlock.h"

namespace subdivision
{

/// Appends rows [begin, end) of a kind. group(g, columns) writes the columns of rows OfEach g to
/// OfEach g + OfEach - 1, or returns false where one of these is not regular; other(row) then
/// appends the entries of such a row.
template <int OfEach, std::size_t N, typename Id, typename Group, typename Other>
void AppendRegularGroups(const std::array<double, N>& weights, vtkIdType begin, vtkIdType end,
  const Group& group, const Other& other, RowBlock<Id>& rows)
{
  while (begin < end)
  {
    if (begin % OfEach == 0)
    {
      const vtkIdType first = begin / OfEach;
      begin += rows.template AddGroups<OfEach>(weights, (end - begin) / OfEach,
        [&](vtkIdType i, Id* columns) { return group(first + i, columns); });
    }
    if (begin == end)
    {
      return;
    }
    Id columns[OfEach * N]; // a group in which some row is not regular, or one that is cut
    const bool isRegular = group(begin / OfEach, columns);
    const Id* own = columns + N * static_cast<std::size_t>(begin % OfEach);
    rows.AddRun(weights, isRegular ? 1 : 0,
      [&](vtkIdType, Id* to)
      {
        std::copy(own, own + N, to);
        return true;
      });
    if (!isRegular)
    {
      other(begin);
      rows.EndRow();
    }
    ++begin;
  }
}

/// Calls act(kind, begin, end) for the parts of rows [begin, end) that are of each kind, and count
/// from the first row of the kind; `sizes` is how many rows each kind has.
template <std::size_t Kinds, typename Act>
void ForKindsOfRows(
  const std::array<vtkIdType, Kinds>& sizes, vtkIdType begin, vtkIdType end, const Act& act)
{
  for (std::size_t kind = 0; kind < Kinds; ++kind)
  {
    const vtkIdType first = std::max<vtkIdType>(begin, 0);
    const vtkIdType last = std::min(end, sizes[kind]);
    if (first < last)
    {
      act(kind, first, last);
    }
    begin -= sizes[kind];
    end -= sizes[kind];
  }
}

}

#endif
