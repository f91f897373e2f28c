// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/OpenSplits.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Private/Reading/FlatPart.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace subdivision
{
namespace
{

/// The input cells that have split edges.
template <typename Id>
std::vector<Id> FindSplitCells(const RedGreen<Id>& state)
{
  const Id given = state.GetNumberOfInputVertices();
  Buffer<unsigned char> isFound(state.GetNumberOfInputCells(), 0);
  std::vector<Id> cells;
  ForEachInTurn(vtkIdType(state.GetNumberOfVertices() - given),
    [&](vtkIdType i)
    {
      const Id vertex = given + static_cast<Id>(i);
      const std::array<Id, 2> ends = state.GetEnds(vertex);
      if (ends[0] < given && ends[1] < given)
      {
        state.ForInputCells(vertex,
          [&](Id cell)
          {
            isFound[cell] ? void() : cells.push_back(cell);
            isFound[cell] = 1;
          });
      }
    });
  return cells;
}

/// Calls use(corners) for the faces of tetrahedra with split edges.
template <typename Id, typename Use>
void ForSplitFaces(const RedGreen<Id>& state, const std::vector<Id>& cells, const Use& use)
{
  for (const Id id : InTurn(cells))
  {
    const auto cell = state.GetCell(id);
    const unsigned int splits = state.GetSplitEdges(id);
    for (int face = 0; cell.Dimension == 3 && face < 4; ++face)
    {
      const int* local = tetrahedron::FaceVertices[face];
      const unsigned int edges = 1u << tetrahedron::EdgeOf[local[0]][local[1]] |
        1u << tetrahedron::EdgeOf[local[1]][local[2]] |
        1u << tetrahedron::EdgeOf[local[0]][local[2]];
      if (splits & edges)
      {
        use(std::array<Id, 3>{
          cell.Vertices[local[0]], cell.Vertices[local[1]], cell.Vertices[local[2]] });
      }
    }
  }
}

/// Three corners for each line and triangle that is split, the last one of lines twice, and for
/// each split face of one tetrahedron. All tetrahedra at a split face are split, so that hashes of
/// faces, summed up at their points, cancel inside.
template <typename Id>
Buffer<int> FindOpenParts(const RedGreen<Id>& state, const std::vector<Id>& cells)
{
  Buffer<std::uint64_t> sums(state.GetNumberOfInputVertices(), 0);
  ForSplitFaces(state, cells,
    [&sums](const std::array<Id, 3>& corners)
    {
      std::uint64_t hash = 0;
      for (const Id corner : corners)
      {
        hash += (static_cast<std::uint64_t>(corner) + 1) * 0x9e3779b97f4a7c15ull;
      }
      hash = (hash ^ (hash >> 32)) * 0xbf58476d1ce4e5b9ull;
      for (const Id corner : corners)
      {
        sums[corner] ^= hash ^ (hash >> 29);
      }
    });
  std::vector<int> parts;
  const auto add = [&parts](const auto& corners)
  {
    for (int i = 0; i < 3; ++i)
    {
      parts.push_back(static_cast<int>(corners[i]));
    }
  };
  ForSplitFaces(state, cells,
    [&](const std::array<Id, 3>& corners)
    {
      if (sums[corners[0]] && sums[corners[1]] && sums[corners[2]])
      {
        add(corners);
      }
    });
  for (const Id id : InTurn(cells))
  {
    const auto cell = state.GetCell(id);
    if (cell.Dimension == 1 || cell.Dimension == 2)
    {
      add(std::array<Id, 3>{ cell.Vertices[0], cell.Vertices[1], cell.Vertices[cell.Dimension] });
    }
  }
  Buffer<int> list(static_cast<vtkIdType>(parts.size()));
  std::copy(parts.begin(), parts.end(), list.begin());
  return list;
}

/// How far from a part points may be that lie on it (FlatPart.h), or more.
double FindTolerance(const double* points, const Buffer<int>& parts)
{
  double most = 0.;
  for (const vtkIdType i : InTurn(parts.size()))
  {
    const double* a = points + 3 * vtkIdType(parts[i]);
    const double* b = points + 3 * vtkIdType(parts[i % 3 < 2 ? i + 1 : i - 2]);
    most = std::max(most, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  return FlatPart::Tolerance * most;
}

}

template <typename Id>
bool HasOpenSplits(const RedGreen<Id>& state, const Coordinates& points)
{
  const Buffer<int> parts = state.GetNumberOfInputVertices() <= std::numeric_limits<int>::max()
    ? FindOpenParts(state, FindSplitCells(state))
    : Buffer<int>();
  if (parts.empty())
  {
    return false;
  }
  const double* x = points;
  const SimplexTree tree(x, 3, parts);
  const double tolerance = FindTolerance(x, parts);
  std::atomic<bool> isFound{ false };
  ForEach(vtkIdType(state.GetNumberOfInputVertices()),
    [&](vtkIdType point)
    {
      const double* at = x + 3 * point;
      Box around;
      around.Add(at);
      for (int k = 0; k < 3; ++k)
      {
        around.Low[k] -= tolerance;
        around.High[k] += tolerance;
      }
      tree.ForEachWhere([&](const Box& box) { return !isFound && box.Meets(around); },
        [&](vtkIdType i)
        {
          const int* ids = parts.data() + 3 * i;
          const double* corners[3] = { x + 3 * ids[0], x + 3 * ids[1], x + 3 * ids[2] };
          Box box;
          std::for_each(corners, corners + 3, [&box](const double* corner) { box.Add(corner); });
          if (box.Meets(around) && std::find(ids, ids + 3, static_cast<int>(point)) == ids + 3 &&
            FlatPart(corners, ids[1] == ids[2] ? 2 : 3).Find(at) != FlatPart::Off)
          {
            isFound = true;
          }
        });
    });
  return isFound;
}

SUBDIVISION_COMPILE_FUNCTION(HasOpenSplits);

}
