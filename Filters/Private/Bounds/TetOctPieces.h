// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctPieces.h
 * The solids that a few steps of the tet/oct scheme make of a tetrahedron and of an octahedron
 * (Mathematics 10), and where its points are among the cells that are written.
 */
#ifndef SubdivisionObjects_TetOctPieces_h
#define SubdivisionObjects_TetOctPieces_h

#include "vtkType.h"

#include <array>
#include <vector>

namespace subdivision
{

struct TetOctPieces
{
  static constexpr int Steps = 3;
  static constexpr int Divisions = 1 << Steps; ///< of an edge, after fewer steps too
  /// A tetrahedron has a corner at 0 and one at 8 of each axis. An octahedron has its vertices at 8
  /// and -8 of each axis, in this order.
  using Place = std::array<int, 3>;

  struct Solid
  {
    bool IsOct;
    int FirstCell; ///< in the order in which cells are written; an octahedron has four
    std::array<Place, 6> Corners; ///< four of them are used in a tetrahedron
    int CountCorners() const { return this->IsOct ? 6 : 4; }
  };
  std::vector<Solid> Solids; ///< after all steps

  /// `steps`: no more than Steps.
  static const TetOctPieces& Get(bool isOct, int steps = Steps);

  /// The vertices of the quarters that an octahedron is written as; the first pair is the diagonal.
  using QuarterTable = std::array<std::array<int, 4>, 4>;
  static const QuarterTable& GetQuarters();
  /// Where a vertex of an octahedron is, in multiples of Divisions.
  static Place GetVertex(int vertex);
  /// The vertices of an octahedron, in the order of QuarterTable, of four cells with four points.
  static std::array<vtkIdType, 6> Join(const vtkIdType* quarters);
};

}

#endif
