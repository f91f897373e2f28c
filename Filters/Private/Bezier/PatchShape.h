// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchShape.h
 * The Bezier cells that limits are written as, and how their control points follow from points of
 * the limit.
 *
 * Where all is regular, limits are polynomials: of degree 3 over a line, 4 over a triangle (Loop),
 * 3 by 3 over a quad (Catmull-Clark), 5 over a tetrahedron (box spline). A mesh that was made by
 * further steps has points of the limit where the edges of a cell are divided in 4 or 8. As many of
 * these as the polynomial has control points, its *nodes*, give it. Nodes on an edge or face give
 * the control points there, so that cells that share an edge have the same curve on it. So where a
 * mesh has cells of a higher degree, all others are raised to it.
 */
#ifndef SubdivisionObjects_PatchShape_h
#define SubdivisionObjects_PatchShape_h

#include "Private/Roots/RootLattice.h"

#include <array>
#include <vector>

namespace subdivision
{

/// A part of a cell that is like it: its first corner and its axes, which lead to the next corners
/// (of a quad, to the second and the last), on the cell's lattice.
struct LatticePart
{
  FrameNode Origin{ { 0, 0, 0 } };
  std::array<FrameNode, 3> Axes{ { { { 0, 0, 0 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } } } };

  /// A point of the part's own lattice, whose axes have `divisions` parts.
  FrameNode At(const FrameNode& point, int divisions) const;
  /// A part of this part, given on its lattice of so many divisions.
  LatticePart Take(const LatticePart& child, int divisions = 2) const;
};

struct PatchShape
{
  /// In the order of CellShape.
  enum Kind : int
  {
    Curve,
    Triangle,
    Quad,
    Tetrahedron,
    NumberOfKinds
  };

  int Dimension;
  int Corners;
  int Degree;
  int CellType;     ///< of VTK
  int SampleLevels; ///< nodes need the points of so many further steps
  int Divisions;    ///< the parts of an edge then
  /// Where each control point has its node, in VTK's order of points; corners come first.
  std::vector<FrameNode> Nodes;
  /// A row for each control point: the weights of the values at the nodes.
  std::vector<std::vector<double>> Weights;
  /// Points of the lattice with twice as many divisions, and the weights that give the polynomial
  /// there.
  std::vector<FrameNode> Checked;
  std::vector<std::vector<double>> CheckWeights;
  /// Where the corners are, and the children in the order of a step, on the lattice of two
  /// divisions.
  std::vector<FrameNode> CornerPoints;
  std::vector<LatticePart> Children;

  /// Of the least degree that is exact where all is regular.
  static const PatchShape& Get(Kind kind);
  static Kind FindKind(CellShape shape) { return static_cast<Kind>(static_cast<int>(shape) - 1); }
  /// Of that degree, if it is larger: 4 or 5 for curves, 5 for triangles.
  static const PatchShape& Get(Kind kind, int degree);
};

}

#endif
