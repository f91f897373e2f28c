// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Complex/TetOrder.h"

#include "Core/Memory/SimplexStarts.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace subdivision
{
namespace
{

double SquaredLength(const double* a, const double* b)
{
  double sum = 0.;
  for (int i = 0; i < 3; ++i)
  {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return sum;
}

/// Finds the marked pair of edges among four vertices sorted by id: returns the position (1 to 3)
/// of the vertex that a marked edge joins with the first. Squared lengths that exceed the least by
/// no more than a relative `tie` count as equal to it.
int FindPartner(const double* const sorted[4], double tie)
{
  double diagonals[4] = {};
  double edges[4] = {};
  double shortestDiagonal = std::numeric_limits<double>::max();
  for (int partner = 1; partner < 4; ++partner)
  {
    const int c = partner == 1 ? 2 : 1;
    const int d = 6 - partner - c;
    double sums[2][3];
    for (int i = 0; i < 3; ++i)
    {
      sums[0][i] = sorted[0][i] + sorted[partner][i];
      sums[1][i] = sorted[c][i] + sorted[d][i];
    }
    diagonals[partner] = SquaredLength(sums[0], sums[1]);
    edges[partner] =
      std::max(SquaredLength(sorted[0], sorted[partner]), SquaredLength(sorted[c], sorted[d]));
    shortestDiagonal = std::min(shortestDiagonal, diagonals[partner]);
  }
  double shortestEdge = std::numeric_limits<double>::max();
  for (int partner = 1; partner < 4; ++partner)
  {
    if (diagonals[partner] <= shortestDiagonal * (1. + tie))
    {
      shortestEdge = std::min(shortestEdge, edges[partner]);
    }
  }
  for (int partner = 1; partner < 4; ++partner)
  {
    if (diagonals[partner] <= shortestDiagonal * (1. + tie) &&
      edges[partner] <= shortestEdge * (1. + tie))
    {
      return partner;
    }
  }
  return 1; // only if lengths are NaN
}

}

void OrderTet(vtkIdType* tet, const Coordinates& points, const vtkIdType* globalIds,
  vtkIdType numberOfGlobalIds)
{
  int sorted[4] = { 0, 1, 2, 3 };
  auto key = [&](int i) // by index where global ids are missing, or not unique
  {
    const bool known = globalIds && tet[i] < numberOfGlobalIds;
    return std::make_tuple(globalIds && !known, known ? globalIds[tet[i]] : 0, tet[i]);
  };
  std::sort(sorted, sorted + 4, [&](int a, int b) { return key(a) < key(b); });
  const double* corners[4];
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = points + 3 * tet[sorted[i]];
  }
  const int partner = FindPartner(corners, points.Tie);
  // pairs[i] is the vertex that a marked edge joins with vertex i of the tetrahedron.
  int pairs[4];
  const int c = partner == 1 ? 2 : 1;
  const int d = 6 - partner - c;
  pairs[sorted[0]] = sorted[partner];
  pairs[sorted[partner]] = sorted[0];
  pairs[sorted[c]] = sorted[d];
  pairs[sorted[d]] = sorted[c];
  if (pairs[0] == 1) // even permutations of the last three bring pairs[0] to position 2
  {
    const vtkIdType order[3] = { tet[3], tet[1], tet[2] };
    std::copy(order, order + 3, tet + 1);
  }
  else if (pairs[0] == 3)
  {
    const vtkIdType order[3] = { tet[2], tet[3], tet[1] };
    std::copy(order, order + 3, tet + 1);
  }
}

void OrderTets(SimplexList& simplices, const Coordinates& points, const vtkIdType* globalIds,
  vtkIdType numberOfGlobalIds)
{
  if (CountDimensions(simplices)[3] == 0)
  {
    return;
  }
  const SimplexStarts entries = FindCorners(SimplexView(simplices));
  ForEach(simplices.GetNumberOfSimplices(),
    [&](vtkIdType i)
    {
      if (simplices.Dimensions[i] == 3)
      {
        OrderTet(simplices.Connectivity.data() + entries[i], points, globalIds, numberOfGlobalIds);
      }
    });
}

}
