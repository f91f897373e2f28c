// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctCells.h
 * Writes the cells of a tet/oct level as tetrahedra: each octahedron becomes four tetrahedra around
 * a diagonal (Mathematics 10), which are called its pieces.
 *
 * The descendants of one control tetrahedron are consecutive in the output, and so are the
 * descendants of each cell of a level between: of a tetrahedron first the four tetrahedra at its
 * vertices, then the octahedron; of an octahedron first the six octahedra, then the eight
 * tetrahedra. As an octahedron counts as four cells, a step makes eight cells out of each cell, as
 * in the box-spline scheme, and RefineRuns serves both. The first four children of a tetrahedron
 * are the same as in the box spline.
 */
#ifndef SubdivisionObjects_TetOctCells_h
#define SubdivisionObjects_TetOctCells_h

#include "Core/Memory/Coordinates.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/TetOct/TetOctComplex.h"

namespace subdivision
{

/// Sorts the six vertices of an octahedron into an order that depends on its vertices and
/// orientation only. Each pair has the smaller one first, pairs ascend by their first vertices, and
/// the last pair is swapped if the orientation requires it.
template <typename Id>
void SortOctahedron(Id vertices[6])
{
  bool odd = false;
  // Without branches, which the processor would mispredict.
  auto swap = [&](int a, int b, bool wanted)
  {
    const Id first = vertices[a];
    const Id second = vertices[b];
    vertices[a] = wanted ? second : first;
    vertices[b] = wanted ? first : second;
  };
  auto order = [&](int a, int b, int size)
  {
    const bool wanted = vertices[b] < vertices[a];
    odd ^= wanted;
    for (int i = 0; i < size; ++i)
    {
      swap(a + i, b + i, wanted);
    }
  };
  order(0, 1, 1);
  order(2, 3, 1);
  order(4, 5, 1);
  order(0, 2, 2);
  order(2, 4, 2);
  order(0, 2, 2);
  swap(4, 5, odd);
}

/// The pair with the shortest diagonal of a sorted octahedron. Where pairs tie, which is up to a
/// relative difference of `tie`, it is the first one.
template <typename Id, typename T>
int FindShortestDiagonal(const Id vertices[6], const T* points,
  double tie = sizeof(T) < sizeof(double) ? SingleTie : DoubleTie)
{
  double lengths[3];
  for (int pair = 0; pair < 3; ++pair)
  {
    const T* p = points + 3 * vtkIdType(vertices[2 * pair]);
    const T* q = points + 3 * vtkIdType(vertices[2 * pair + 1]);
    lengths[pair] = 0.;
    for (int c = 0; c < 3; ++c)
    {
      const double difference = static_cast<double>(p[c]) - static_cast<double>(q[c]);
      lengths[pair] += difference * difference;
    }
  }
  const double limit = std::min({ lengths[0], lengths[1], lengths[2] }) * (1. + tie);
  // Without branches, which the processor would mispredict.
  int shortest = lengths[2] <= limit ? 2 : 0;
  shortest = lengths[1] <= limit ? 1 : shortest;
  return lengths[0] <= limit ? 0 : shortest;
}

/// The four tetrahedra around the diagonal of pair 0, 1 or 2.
template <typename Id, typename Out>
void CutOctahedron(const Id vertices[6], int diagonal, Out tets[16])
{
  constexpr int pieces[16] = { 1, 4, 0, 2, 1, 3, 0, 4, 1, 5, 0, 3, 1, 2, 0, 5 };
  Id turned[6]; // the diagonal first
  for (int i = 0; i < 6; ++i)
  {
    const int from = i + 2 * diagonal;
    turned[i] = vertices[from < 6 ? from : from - 6];
  }
  for (int i = 0; i < 16; ++i)
  {
    tets[i] = static_cast<Out>(turned[pieces[i]]);
  }
}

/// The octahedron that four tetrahedra were cut from, not sorted.
template <typename Id, typename Out>
void JoinOctahedron(const Out tets[16], Id vertices[6])
{
  const Out joined[6] = { tets[2], tets[0], tets[3], tets[5], tets[1], tets[9] };
  for (int i = 0; i < 6; ++i)
  {
    vertices[i] = static_cast<Id>(joined[i]);
  }
}

/// Writes the children of a level's cells as WriteChildren does. `points` are the points of the
/// next level: each octahedron is cut around its shortest diagonal, as TurnOctahedra does. If
/// `points` is null it is cut around any.
template <typename Id, typename Out, typename T>
void WriteTetOctChildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs,
  const T* points, const CellStorage<Out>& out);

/// Writes the children of the children likewise; `points` are the points two steps later. The level
/// was made with Depth::ForRefinement and has no equal cells.
template <typename Id, typename Out, typename T>
void WriteTetOctGrandchildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs,
  const T* points, const CellStorage<Out>& out);

/// Writes for each output cell the number of the octahedron that it is a piece of, or -1. Octahedra
/// are numbered in output order. `runs` are runs of the output, `steps` steps after the control
/// level.
void NumberOctahedra(const std::vector<CellRun>& runs, int steps, vtkIdType* numbers);

/**
 * Cuts each octahedron anew, around its shortest diagonal. Diagonals whose squared lengths differ
 * by no more than a relative 1e-9 (1e-5 if T is float) tie, because lattices have exact ties that
 * rounding breaks. Of diagonals that tie the one with the smallest vertex is taken. `octahedra` is
 * the result of NumberOctahedra; the connectivity of cell i starts at offsets[i].
 */
template <typename Out, typename T>
void TurnOctahedra(const vtkIdType* octahedra, vtkIdType cells, const Out* offsets,
  Out* connectivity, const T* points);

/// Whether all octahedra are already cut as TurnOctahedra would cut them.
template <typename Out, typename T>
bool AreTurned(const vtkIdType* octahedra, vtkIdType cells, const Out* offsets,
  const Out* connectivity, const T* points);

/// Whether `cells` are the cells of a level, with octahedra cut around any diagonals.
template <typename Id>
bool HasCells(
  const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, const SimplexList& cells);

/// For each child cell the cell of `cells` whose values it takes. A cell of dimension d counts as
/// having 2^d children. A child of an octahedron takes the values of the piece that it lies in, or
/// of the first if there are several.
template <typename Id>
std::vector<vtkIdType> FindParents(
  const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, const SimplexList& cells);

}

#endif
