// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QuadraticPieces.h
 * The limit as quadratic simplices.
 *
 * A cell of the level before the last one has its corners and the middles of its edges, faces and
 * inside among the points. It is cut into simplices that begin at the corner with the least id, and
 * so are its faces, so that neighbours fit whatever types they have. All nodes of the simplices are
 * such middles.
 */
#ifndef SubdivisionObjects_QuadraticPieces_h
#define SubdivisionObjects_QuadraticPieces_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPointSet;

namespace subdivision
{

/// A simplex of some dimension with its corners, then the middles of its edges: 01, 02, 12 of
/// triangles, and 03, 13, 23 more of tetrahedra.
struct QuadraticPiece
{
  static constexpr int CountNodes(int dimension) { return (dimension + 1) * (dimension + 2) / 2; }

  std::array<vtkIdType, 10> Nodes;
  vtkIdType Cell; ///< of the mesh, which has its data
};

/// Where the nodes of a piece are.
std::array<std::array<double, 3>, 10> GetNodes(
  vtkPointSet* mesh, const QuadraticPiece& piece, int dimension);
/// The largest distance between the middle of an edge and the middle of its ends.
double FindBend(const std::array<std::array<double, 3>, 10>& nodes, int dimension);

struct QuadraticPieces
{
  /// Of each dimension, in the order of the cells.
  std::array<std::vector<QuadraticPiece>, 4> Pieces;
  /// How far a straight edge of a piece is away from the middle node at most.
  double Bend = 0.;
  /// How far the pieces of one level coarser are away from the points between their nodes; 0 if
  /// that was not asked for.
  double CoarserDeviation = 0.;
  /// A cell that is no part of one that was split, and so became no piece; -1: there is none.
  vtkIdType Strange = -1;
};

/// `mesh`: of a level, all points on the limit. `measures`: whether CoarserDeviation is asked for;
/// then the level is at least 2, else 1.
QuadraticPieces MakeQuadraticPieces(vtkPointSet* mesh, bool measures);

}

#endif
