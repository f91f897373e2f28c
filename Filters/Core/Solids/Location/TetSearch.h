// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetSearch.h
 * Which tetrahedra hold given points: a search for many points at once.
 *
 * Points are sorted into groups that lie close together, and the points of a group into bins. Each
 * group takes the tetrahedra near it, one after the other, and compares each with all points in
 * bins that it meets. The frame of a tetrahedron is made once for all of them. Rows of bins are
 * consecutive points; processors test several at a time, in single precision. Weights are computed
 * of the few points that may be inside. Tetrahedra need no sorting: runs of consecutive ones have
 * boxes, because the children of a cell are consecutive.
 */
#ifndef SubdivisionObjects_TetSearch_h
#define SubdivisionObjects_TetSearch_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/Box.h"

#include <vector>

namespace subdivision
{

/// Weights up to these below 0 are taken for 0. A point that no tetrahedron holds by the first is
/// searched by the second, which is not smaller. They are up to 1e-4.
struct HoldTolerances
{
  double Tight;
  double Loose;
};

class TetSearch
{
public:
  TetSearch() = default;
  /// Points and corners, four for each tetrahedron, must outlive the search. Points are finite
  /// where tetrahedra use them.
  TetSearch(const double* points, const Buffer<int>& corners);

  int GetNumberOfTets() const { return this->Size; }

  /// For each of `size` points the first of the tetrahedra that hold it, with the weights of the
  /// corners 1 to 3 (CompleteWeights in CornerRows.h); -1 if there is none. A tetrahedron whose
  /// volume is a denormal number may be missed.
  void Find(const double* points, int size, const HoldTolerances& tolerances, int* tets,
    double* weights) const;

private:
  struct Group;
  void Visit(std::size_t level, int node, Group& group) const;
  void FindInTet(int tet, Group& group) const;

  static constexpr int Width = 8; ///< children of a node, tetrahedra of a leaf

  const double* Points = nullptr;
  const int* Corners = nullptr;
  int Size = 0;
  std::vector<Buffer<Box>> Levels; ///< boxes of Width tetrahedra each, then of Width boxes of the
                                   ///< level before each; the last level has one
};

}

#endif
