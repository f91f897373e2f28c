// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceLists.h
 * Which pieces reach into which slices of an image.
 */
#ifndef SubdivisionObjects_PieceLists_h
#define SubdivisionObjects_PieceLists_h

#include "Core/Memory/Loops.h"
#include "Private/Samples/SampledImage.h"

#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

namespace subdivision
{

/// The slices that one thread fills: so many, but at the end.
constexpr int SlicesOfSlab = 4;

inline vtkIdType CountSlabs(const SampleGrid& grid)
{
  return (grid.Extent[5] - grid.Extent[4] + SlicesOfSlab) / SlicesOfSlab;
}

/// The first slice of a slab, and one past its last.
inline std::pair<int, int> GetSlices(const SampleGrid& grid, vtkIdType slab)
{
  const int begin = grid.Extent[4] + static_cast<int>(slab) * SlicesOfSlab;
  return { begin, std::min(begin + SlicesOfSlab, grid.Extent[5] + 1) };
}

/// Calls visit(i, j, k, number in the slab) for the samples of some slices in a box.
template <typename Visit>
void ForSamplesIn(const SampleGrid& grid, const std::pair<int, int>& slices, const Place& low,
  const Place& high, const Visit& visit)
{
  const auto& extent = grid.Extent;
  const vtkIdType width = extent[1] - extent[0] + 1;
  const vtkIdType height = extent[3] - extent[2] + 1;
  const int firstI = grid.GetFirst(0, low[0]);
  const int lastI = grid.GetLast(0, high[0]);
  const int lastJ = grid.GetLast(1, high[1]);
  const int lastK = std::min(grid.GetLast(2, high[2]), slices.second - 1);
  for (int k = std::max(grid.GetFirst(2, low[2]), slices.first); k <= lastK; ++k)
  {
    for (int j = grid.GetFirst(1, low[1]); j <= lastJ; ++j)
    {
      const vtkIdType row = width * (j - extent[2] + height * (k - slices.first)) - extent[0];
      for (int i = firstI; i <= lastI; ++i)
      {
        visit(i, j, k, row + i);
      }
    }
  }
}

/// Lists numbers for each slab, in ascending order.
class SlabLists
{
public:
  /// `find(i)`: from where to where number i reaches along the third axis.
  template <typename Find>
  SlabLists(const SampleGrid& grid, vtkIdType size, const Find& find)
    : Starts(CountSlabs(grid) + 1, 0)
  {
    std::vector<std::pair<int, int>> slabs(size);
    ForEach(size,
      [&](vtkIdType i)
      {
        const std::pair<double, double> reach = find(i);
        const int first = grid.GetFirst(2, reach.first) - grid.Extent[4];
        const int last = grid.GetLast(2, reach.second) - grid.Extent[4];
        slabs[i] = { first / SlicesOfSlab, first > last ? -1 : last / SlicesOfSlab };
      });
    for (const auto& [first, last] : InTurn(slabs))
    {
      for (int s = first; s <= last; ++s)
      {
        ++this->Starts[s + 1];
      }
    }
    for (std::size_t s = 1; s < this->Starts.size(); ++s)
    {
      this->Starts[s] += this->Starts[s - 1];
    }
    this->Numbers.resize(this->Starts.back());
    std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
    for (const vtkIdType i : InTurn(size))
    {
      for (int s = slabs[i].first; s <= slabs[i].second; ++s)
      {
        this->Numbers[next[s]++] = i;
      }
    }
  }

  template <typename Act>
  void ForNumbers(vtkIdType slab, const Act& act) const
  {
    for (vtkIdType n = this->Starts[slab]; n < this->Starts[slab + 1]; ++n)
    {
      act(this->Numbers[n]);
    }
  }

private:
  std::vector<vtkIdType> Starts;
  std::vector<vtkIdType> Numbers;
};

/// A piece of one of the meshes.
struct ListedPiece
{
  std::size_t Mesh;
  const QuadraticPiece* Piece;
};

/// Samples of some slices.
inline vtkIdType CountSamplesOf(const SampleGrid& grid, const std::pair<int, int>& slices)
{
  const auto& extent = grid.Extent;
  return vtkIdType(slices.second - slices.first) * (extent[1] - extent[0] + 1) *
    (extent[3] - extent[2] + 1);
}

/// All pieces of a dimension.
inline std::vector<ListedPiece> ListPieces(const std::vector<SampledMesh>& meshes, int dimension)
{
  std::vector<ListedPiece> all;
  for (std::size_t m = 0; m < meshes.size(); ++m)
  {
    for (const QuadraticPiece& piece : InTurn(meshes[m].Pieces.Pieces[dimension]))
    {
      all.push_back({ m, &piece });
    }
  }
  return all;
}

/// The shares of the nodes of a piece of any dimension, from the weights of its corners but the
/// first; in the order of the nodes.
inline std::array<double, 10> GetSharesOfPiece(int dimension, const Place& weights)
{
  constexpr int lines[3] = { 0, 1, 4 };
  constexpr int triangles[6] = { 0, 1, 2, 4, 5, 6 };
  const auto all = GetShares(weights);
  std::array<double, 10> shares = all;
  for (int n = 0; dimension < 3 && n < QuadraticPiece::CountNodes(dimension); ++n)
  {
    shares[n] = all[dimension == 2 ? triangles[n] : lines[n]];
  }
  return shares;
}

inline Place Blend(
  const std::array<Place, 10>& nodes, const std::array<double, 10>& shares, int size)
{
  Place sum{};
  for (int n = 0; n < size; ++n)
  {
    for (int x = 0; x < 3; ++x)
    {
      sum[x] += shares[n] * nodes[n][x];
    }
  }
  return sum;
}

/// From where to where a piece reaches along the third axis, and `more` on both sides.
inline std::pair<double, double> FindReach(
  const std::array<Place, 10>& nodes, int dimension, double more)
{
  std::pair<double, double> reach(nodes[0][2], nodes[0][2]);
  for (int n = 1; n < QuadraticPiece::CountNodes(dimension); ++n)
  {
    reach.first = std::min(reach.first, nodes[n][2]);
    reach.second = std::max(reach.second, nodes[n][2]);
  }
  more += FindBend(nodes, dimension);
  return { reach.first - more, reach.second + more };
}

/// How far the nodes of a piece are away from the first one along an axis at most, in units of
/// these.
inline double FindSize(const std::array<Place, 10>& nodes, int dimension, const Place& units)
{
  double size = 0.;
  for (int n = 1; n < QuadraticPiece::CountNodes(dimension); ++n)
  {
    for (int x = 0; x < 3; ++x)
    {
      size = std::max(size, std::abs(nodes[n][x] - nodes[0][x]) / units[x]);
    }
  }
  return size;
}

/// How often a number that each halving of edges divides by `part` is too large, 8 times at most.
inline int CountHalvings(double number, double most, double part)
{
  int halvings = 0;
  for (; number > most && halvings < 8; number /= part)
  {
    ++halvings;
  }
  return halvings;
}

/// A straight part of a triangle or line: its corners, and their weights in the piece.
struct StraightPart
{
  std::array<Place, 3> Corners;
  std::array<Place, 3> Weights;
};

/// Calls act(part) for the parts of a triangle, line or point whose edges are halved `halvings`
/// times.
template <typename Act>
void ForStraightParts(
  const std::array<Place, 10>& nodes, int dimension, int halvings, const Act& act)
{
  const int cuts = 1 << halvings;
  const int size = QuadraticPiece::CountNodes(dimension);
  const auto call = [&](std::initializer_list<std::array<int, 2>> corners)
  {
    StraightPart part{};
    int c = 0;
    for (const auto& [u, v] : corners)
    {
      part.Weights[c] = { double(u) / cuts, double(v) / cuts, 0. };
      part.Corners[c] = Blend(nodes, GetSharesOfPiece(dimension, part.Weights[c]), size);
      ++c;
    }
    act(part);
  };
  if (dimension == 0)
  {
    call({ { 0, 0 } });
  }
  for (int u = 0; dimension == 1 && u < cuts; ++u)
  {
    call({ { u, 0 }, { u + 1, 0 } });
  }
  for (int v = 0; dimension == 2 && v < cuts; ++v)
  {
    for (int u = 0; u + v < cuts; ++u)
    {
      call({ { u, v }, { u + 1, v }, { u, v + 1 } });
      if (u + v + 1 < cuts)
      {
        call({ { u + 1, v }, { u + 1, v + 1 }, { u, v + 1 } });
      }
    }
  }
}

/// The smallest box around a part, with `more` on all sides.
inline std::pair<Place, Place> FindBox(const StraightPart& part, int dimension, const Place& more)
{
  std::pair<Place, Place> box(part.Corners[0], part.Corners[0]);
  for (int x = 0; x < 3; ++x)
  {
    for (int c = 1; c <= dimension; ++c)
    {
      box.first[x] = std::min(box.first[x], part.Corners[c][x]);
      box.second[x] = std::max(box.second[x], part.Corners[c][x]);
    }
    box.first[x] -= more[x];
    box.second[x] += more[x];
  }
  return box;
}

/// Calls visit(i, j, k, number in the slab, part, nearest) for the samples of some slices in boxes
/// around the straight parts of a piece.
template <typename Visit>
void ForSamplesNear(const SampleGrid& grid, const std::pair<int, int>& slices,
  const std::array<Place, 10>& nodes, int dimension, int halvings, double reach, const Visit& visit)
{
  ForStraightParts(nodes, dimension, halvings,
    [&](const StraightPart& part)
    {
      const auto box = FindBox(part, dimension, { reach, reach, reach });
      ForSamplesIn(grid, slices, box.first, box.second,
        [&](int i, int j, int k, vtkIdType sample)
        {
          visit(i, j, k, sample, part,
            FindNearest(part.Corners.data(), dimension + 1,
              { grid.GetPlace(0, i), grid.GetPlace(1, j), grid.GetPlace(2, k) }));
        });
    });
}

}

#endif
