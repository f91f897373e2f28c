// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctCells.h
 * The output of a tet/oct level: its cells as tetrahedra, octahedra as four around a diagonal
 * (Mathematics 10).
 *
 * The cells that come from one control tetrahedron follow each other, and so do those that come
 * from any cell in between: of a tetrahedron the four at its vertices, then the octahedron; of an
 * octahedron the six octahedra, then the eight tetrahedra. With four for each octahedron that is
 * always eight times as many, as if tetrahedra were split as by the box spline: so runs (CellRun in
 * SimplicialComplex.h) are refined as there too. The first four children of a tetrahedron are those
 * of the box spline.
 */
#ifndef SubdivisionObjects_TetOctCells_h
#define SubdivisionObjects_TetOctCells_h

#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/TetOct/TetOctComplex.h"

namespace subdivision
{

/// Six vertices of an octahedron in the order that depends on nothing but the octahedron: in each
/// pair and among the pairs the smallest first, but the last pair turned where orientation needs
/// it.
template <typename Id>
void SortOctahedron(Id vertices[6])
{
  bool odd = false;
  auto swap = [&](int a, int b, bool wanted) // no branches: no processor could predict them
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

/// Writes the children of a level's cells as WriteChildren does; octahedra around the diagonals
/// that TurnOctahedra would turn them to, or, where `points` is null, around any.
template <typename Id, typename Out, typename T>
void WriteTetOctChildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs,
  const T* points, const CellStorage<Out>& out);

/// Writes the children of the children; `points` of their level. The level has all that a further
/// step needs, and no equal cells.
template <typename Id, typename Out, typename T>
void WriteTetOctGrandchildren(const TetOctLevel<Id>& level, const std::vector<CellRun>& runs,
  const T* points, const CellStorage<Out>& out);

/// The octahedron of each cell, numbered in their order, -1 where there is none. `runs` are those
/// of a level `steps` steps below the control level.
void NumberOctahedra(const std::vector<CellRun>& runs, int steps, vtkIdType* numbers);

/**
 * Turns each octahedron to its shortest diagonal. Diagonals whose squared lengths differ by less
 * than a relative 1e-9 tie, or 1e-5 where T is float, as lattices have exact ties that rounding
 * breaks; of these the one with the smallest vertex is taken. `octahedra` as NumberOctahedra gives
 * them; four vertices for each of these, the first of cell i at offsets[i].
 */
template <typename Out, typename T>
void TurnOctahedra(const vtkIdType* octahedra, vtkIdType cells, const Out* offsets,
  Out* connectivity, const T* points);

/// Whether all octahedra are turned so.
template <typename Out, typename T>
bool AreTurned(const vtkIdType* octahedra, vtkIdType cells, const Out* offsets,
  const Out* connectivity, const T* points);

/// Whether some cells are those of a level, around whichever diagonals.
template <typename Id>
bool HasCells(
  const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, const SimplexList& cells);

/// For each of the 2^d children that a cell of dimension d is counted to have, the cell whose
/// values it takes: where it lies in several pieces of an octahedron, the first.
template <typename Id>
std::vector<vtkIdType> FindParents(
  const TetOctLevel<Id>& level, const std::vector<CellRun>& runs, const SimplexList& cells);

}

#endif
