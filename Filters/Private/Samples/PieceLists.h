// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceLists.h
 * Which pieces reach into which slabs of an image.
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

inline vtkIdType CountSamplesOf(const SampleGrid& grid)
{
  const auto& extent = grid.Extent;
  return vtkIdType(extent[1] - extent[0] + 1) * (extent[3] - extent[2] + 1) *
    (extent[5] - extent[4] + 1);
}

/// Slabs are what one thread fills at a time: slices of an image or, of a large one, rows of a
/// slice, so that each takes less than a tenth of a second. Their samples follow one another.
struct SlabSizes
{
  explicit SlabSizes(const SampleGrid& grid)
  {
    constexpr vtkIdType most = 4096;
    const vtkIdType width = std::max(grid.Extent[1] - grid.Extent[0] + 1, 1);
    const vtkIdType height = std::max(grid.Extent[3] - grid.Extent[2] + 1, 1);
    this->Rows = std::max<vtkIdType>(std::min(height, most / width), 1);
    this->Slices = std::min<vtkIdType>(std::max<vtkIdType>(most / (width * height), 1), 4);
    this->Strips = (height + this->Rows - 1) / this->Rows;
  }
  vtkIdType Rows;
  vtkIdType Slices;
  vtkIdType Strips; ///< how often rows fill a slice
};

inline vtkIdType CountSlabs(const SampleGrid& grid)
{
  const SlabSizes sizes(grid);
  return sizes.Strips * ((grid.Extent[5] - grid.Extent[4] + sizes.Slices) / sizes.Slices);
}

/// The part of an image that is a slab.
inline SampleGrid GetSlab(const SampleGrid& grid, vtkIdType number)
{
  const SlabSizes sizes(grid);
  SampleGrid slab = grid;
  const auto cut = [&](int axis, vtkIdType part, vtkIdType size)
  {
    int* const ends = slab.Extent.data() + 2 * axis;
    ends[0] += static_cast<int>(part * size);
    ends[1] = static_cast<int>(std::min<vtkIdType>(ends[1], ends[0] + size - 1));
  };
  cut(1, number % sizes.Strips, sizes.Rows);
  cut(2, number / sizes.Strips, sizes.Slices);
  return slab;
}

/// The number of the first sample of a slab in the image.
inline vtkIdType GetBegin(const SampleGrid& grid, const SampleGrid& slab)
{
  const auto& extent = grid.Extent;
  const vtkIdType row = slab.Extent[2] - extent[2] +
    vtkIdType(extent[3] - extent[2] + 1) * (slab.Extent[4] - extent[4]);
  return row * (extent[1] - extent[0] + 1);
}

/// Calls visit(i, j, k, number in the slab) for the samples of a slab in a box.
template <typename Visit>
void ForSamplesIn(const SampleGrid& slab, const Place& low, const Place& high, const Visit& visit)
{
  const auto& extent = slab.Extent;
  const vtkIdType width = extent[1] - extent[0] + 1;
  const vtkIdType height = extent[3] - extent[2] + 1;
  const int firstI = slab.GetFirst(0, low[0]);
  const int lastI = slab.GetLast(0, high[0]);
  const int lastJ = slab.GetLast(1, high[1]);
  const int lastK = slab.GetLast(2, high[2]);
  for (int k = slab.GetFirst(2, low[2]); k <= lastK; ++k)
  {
    for (int j = slab.GetFirst(1, low[1]); j <= lastJ; ++j)
    {
      const vtkIdType row = width * (j - extent[2] + height * (k - extent[4])) - extent[0];
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
  /// `find(i)`: the lowest and the highest corner of a box around number i.
  template <typename Find>
  SlabLists(const SampleGrid& grid, vtkIdType size, const Find& find)
    : Starts(CountSlabs(grid) + 1, 0)
  {
    const SlabSizes sizes(grid);
    /// Strips and layers, from the first to the last.
    std::vector<std::array<vtkIdType, 4>> slabs(size);
    ForEach(size,
      [&](vtkIdType i)
      {
        const std::pair<Place, Place> box = find(i);
        const auto set = [&](int axis, vtkIdType slices)
        {
          const vtkIdType first = grid.GetFirst(axis, box.first[axis]) - grid.Extent[2 * axis];
          const vtkIdType last = grid.GetLast(axis, box.second[axis]) - grid.Extent[2 * axis];
          slabs[i][2 * axis - 2] = first / slices;
          slabs[i][2 * axis - 1] = first > last ? -1 : last / slices;
        };
        set(1, sizes.Rows);
        set(2, sizes.Slices);
      });
    const auto forSlabs = [&](vtkIdType i, const auto& act)
    {
      for (vtkIdType layer = slabs[i][2]; layer <= slabs[i][3]; ++layer)
      {
        for (vtkIdType strip = slabs[i][0]; strip <= slabs[i][1]; ++strip)
        {
          act(layer * sizes.Strips + strip);
        }
      }
    };
    for (const vtkIdType i : InTurn(size))
    {
      forSlabs(i, [this](vtkIdType s) { ++this->Starts[s + 1]; });
    }
    for (std::size_t s = 1; s < this->Starts.size(); ++s)
    {
      this->Starts[s] += this->Starts[s - 1];
    }
    this->Numbers.resize(this->Starts.back());
    std::vector<vtkIdType> next(this->Starts.begin(), this->Starts.end() - 1);
    for (const vtkIdType i : InTurn(size))
    {
      forSlabs(i, [&](vtkIdType s) { this->Numbers[next[s]++] = i; });
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

/// The smallest box around points, and `more` on all sides.
template <typename Points>
std::pair<Place, Place> FindBox(const Points& points, int size, const Place& more)
{
  std::pair<Place, Place> box(points[0], points[0]);
  for (int x = 0; x < 3; ++x)
  {
    for (int p = 1; p < size; ++p)
    {
      box.first[x] = std::min(box.first[x], points[p][x]);
      box.second[x] = std::max(box.second[x], points[p][x]);
    }
    box.first[x] -= more[x];
    box.second[x] += more[x];
  }
  return box;
}

/// A box around a piece, and `more` on all sides.
inline std::pair<Place, Place> FindReach(
  const std::array<Place, 10>& nodes, int dimension, double more)
{
  more += FindBend(nodes, dimension);
  return FindBox(nodes, QuadraticPiece::CountNodes(dimension), { more, more, more });
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

/// Calls visit(i, j, k, number in the slab, part, nearest) for the samples of a slab in boxes
/// around the straight parts of a piece.
template <typename Visit>
void ForSamplesNear(const SampleGrid& slab, const std::array<Place, 10>& nodes, int dimension,
  int halvings, double reach, const Visit& visit)
{
  ForStraightParts(nodes, dimension, halvings,
    [&](const StraightPart& part)
    {
      const auto box = FindBox(part.Corners, dimension + 1, { reach, reach, reach });
      ForSamplesIn(slab, box.first, box.second,
        [&](int i, int j, int k, vtkIdType sample)
        {
          visit(i, j, k, sample, part,
            FindNearest(part.Corners.data(), dimension + 1,
              { slab.GetPlace(0, i), slab.GetPlace(1, j), slab.GetPlace(2, k) }));
        });
    });
}

}

#endif
