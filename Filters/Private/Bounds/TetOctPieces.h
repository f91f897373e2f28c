// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctPieces.h
 * The quarters that an octahedron of the tet/oct scheme is written as (Mathematics 10).
 */
#ifndef SubdivisionObjects_TetOctPieces_h
#define SubdivisionObjects_TetOctPieces_h

#include "Private/Roots/RootLattice.h"

#include "vtkType.h"

#include <array>

namespace subdivision
{

struct TetOctPieces
{
  /// The vertices of the quarters that an octahedron is written as; the first pair is the diagonal.
  using QuarterTable = std::array<std::array<int, 4>, 4>;
  static const QuarterTable& GetQuarters();
  /// Where a vertex of an octahedron is, where its edges have one division.
  static FrameNode GetVertex(int vertex);
  /// The vertices of an octahedron, in the order of QuarterTable, of four cells with four points.
  static std::array<vtkIdType, 6> Join(const vtkIdType* quarters);
};

}

#endif
