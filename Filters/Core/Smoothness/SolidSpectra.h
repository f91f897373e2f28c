// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidSpectra.h
 * Eigenvalues of the local matrices of vertices of a level of any volume scheme, and of the sheets
 * that end at them.
 */
#ifndef SubdivisionObjects_SolidSpectra_h
#define SubdivisionObjects_SolidSpectra_h

#include "Core/Smoothness/SmoothnessFacts.h"
#include "Core/Solids/Scheme/SolidScheme.h"

#include <functional>
#include <vector>

namespace subdivision
{

/**
 * Of `size` vertices of a level that can be refined (Depth::ForRefinement). The matrix has columns
 * for the vertex and all that its rule reads in later steps: none at a corner, two neighbours on a
 * curve, the neighbours in a surface, all neighbours in a solid or at a blended joint, and in a
 * tet/oct level the opposites in octahedra. So the rule's dimension decides which condition there
 * is; there is none at corners and joints. Equal matrices are solved once in each thread. Matrices
 * of more than LocalMatrix::MostItems rows are not examined: all eigenvalues are
 * 0.
 */
template <typename Level>
void FindSpectra(const Level& level, vtkIdType size,
  const std::function<vtkIdType(vtkIdType)>& vertex, SmoothnessFacts* facts);

/// A sheet at a vertex: its triangles from one curve to the next.
struct Sheet
{
  vtkIdType Vertex;
  int Triangles;
  bool IsCorner; ///< the vertex does not move; otherwise the sheet's two curves are one
};

/// The sheets at corners and on both sides of a curve at its vertices, ascending by vertex. Sheets
/// that end at blended joints, or in no curve, are not among them, nor sheets at a curve which is
/// not their own.
template <typename Level>
std::vector<Sheet> FindSheets(const Level& level);

/// A sheet by the rules of vtkMultiDimensionalSubdivision, whose edges at a curve have the weights
/// of inner edges, or if `modified` the weights of SectorEdges.h; at a corner, which has no angle
/// here, always the former.
SmoothnessFacts ExamineSheet(const Sheet& sheet, bool modified = false);

}

#endif
