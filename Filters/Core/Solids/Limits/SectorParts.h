// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SectorParts.h
 * Collects the sectors of tangents (LimitNormals.h) from many threads.
 */
#ifndef SubdivisionObjects_SectorParts_h
#define SubdivisionObjects_SectorParts_h

#include "Core/Solids/Limits/LimitNormals.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// Edges and triangles around a vertex, from one edge to the next.
template <typename Id>
struct SectorWalk
{
  std::vector<Id> Edges;
  std::vector<Id> Ends; ///< of the edges
  std::vector<Id> Faces;
  bool IsClosed = false;
};

/// Sectors of a stretch of vertices.
template <typename Id>
struct SectorPart
{
  SectorWalk<Id> Walk;   ///< the present one
  std::vector<Id> Sizes; ///< entries of each sector's rows
  std::vector<Id> Columns;
  std::vector<double> First;
  std::vector<double> Second;
  std::vector<vtkIdType> SideSizes;
  std::vector<vtkIdType> Sides;
  std::vector<Id> Triangles;
};

/// One buffer of what several parts hold.
template <typename Id, typename T>
Buffer<T> Join(const std::vector<SectorPart<Id>>& parts, std::vector<T> SectorPart<Id>::* values)
{
  vtkIdType size = 0;
  for (const SectorPart<Id>& part : parts)
  {
    size += static_cast<vtkIdType>((part.*values).size());
  }
  Buffer<T> joined(size);
  T* out = joined.begin();
  for (const SectorPart<Id>& part : parts)
  {
    out = std::copy((part.*values).begin(), (part.*values).end(), out);
  }
  return joined;
}

template <typename Id, typename T>
Buffer<T> JoinOffsets(
  const std::vector<SectorPart<Id>>& parts, std::vector<T> SectorPart<Id>::* sizes)
{
  const Buffer<T> joined = Join(parts, sizes);
  Buffer<T> offsets(joined.size() + 1);
  std::copy(joined.begin(), joined.end(), offsets.begin());
  CountsToOffsets(offsets);
  return offsets;
}

/// The tangents of the sectors of all parts; Sectors.Offsets has how many each vertex has.
template <typename Id>
void JoinSectors(
  const std::vector<SectorPart<Id>>& parts, vtkIdType columns, LimitTangents<Id>& tangents)
{
  CountsToOffsets(tangents.Sectors.Offsets);
  tangents.First.NumberOfColumns = tangents.Second.NumberOfColumns = columns;
  tangents.First.Offsets = JoinOffsets(parts, &SectorPart<Id>::Sizes);
  tangents.First.Columns = Join(parts, &SectorPart<Id>::Columns);
  tangents.First.Weights = Join(parts, &SectorPart<Id>::First);
  tangents.Second.Offsets = JoinOffsets(parts, &SectorPart<Id>::Sizes);
  tangents.Second.Columns = Join(parts, &SectorPart<Id>::Columns);
  tangents.Second.Weights = Join(parts, &SectorPart<Id>::Second);
  tangents.SideOffsets = JoinOffsets(parts, &SectorPart<Id>::SideSizes);
  tangents.Sides = Join(parts, &SectorPart<Id>::Sides);
  tangents.Triangles = Join(parts, &SectorPart<Id>::Triangles);
}

/// The tangents of some vertices: append(row, part) appends the sectors of each, and says how many
/// they are.
template <typename Id, typename Append>
LimitTangents<Id> CollectSectors(vtkIdType rows, vtkIdType vertices, const Append& append)
{
  constexpr vtkIdType block = 4096;
  const vtkIdType blocks = (rows + block - 1) / block;
  std::vector<SectorPart<Id>> parts(blocks);
  LimitTangents<Id> tangents;
  tangents.Sectors.Offsets = Buffer<Id>(rows + 1);
  auto makeBlocks = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType b = begin; b < end; ++b)
    {
      for (vtkIdType row = b * block; row < std::min(rows, (b + 1) * block); ++row)
      {
        tangents.Sectors.Offsets[row] = append(row, parts[b]);
      }
    }
  };
  ForRangesOfBlocks(blocks, makeBlocks);
  JoinSectors(parts, vertices, tangents);
  return tangents;
}

}

#endif
