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

/// Appends rows [begin, end) of the corners of quads (QuadRows). quad(g, corners), called once for
/// each quad in order, writes the corners of rows 4 g to 4 g + 3.
template <typename Id, typename Quad>
void AppendQuads(const std::array<double, 4>& weights, vtkIdType begin, vtkIdType end,
  const Quad& quad, RowBlock<Id>& rows)
{
  while (begin < end)
  {
    const vtkIdType first = begin / 4;
    const vtkIdType at = begin % 4;
    if (at == 0 && end - begin >= 4)
    {
      begin += rows.AddQuads(weights, (end - begin) / 4,
        [&](vtkIdType i, Id* corners)
        {
          quad(first + i, corners);
          return true;
        });
      continue;
    }
    Id corners[4]; // of a quad that is cut
    quad(first, corners);
    begin += rows.AddRun(weights, std::min(4 - at, end - begin),
      [&](vtkIdType i, Id* columns)
      {
        for (vtkIdType k = 0; k < 4; ++k)
        {
          columns[k] = corners[(at + i + k) % 4];
        }
        return true;
      });
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
