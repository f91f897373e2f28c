// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpenPoints.h
 * Warns where cells come apart although most users meant them to be joined: they have points of
 * their own at one place, or nearly, or a point of one lies inside an edge or a face of another.
 */
#ifndef SubdivisionObjects_OpenPoints_h
#define SubdivisionObjects_OpenPoints_h

#include "Core/Cells/CellComplex.h"
#include "Core/Memory/Coordinates.h"
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <functional>
#include <string>
#include <vector>

namespace subdivision
{

struct OpenPointOptions
{
  bool MergesPoints = false; ///< nothing is said of points at one place
  bool ClosesNodes = false;  ///< nor of those that hang
  /// The cure where points are at one place, as the end of a text; empty: MergePoints.
  std::string Cure;
  /// The input cell of a solid (3), a face (2) or an edge (1) of the complex.
  std::function<vtkIdType(int, vtkIdType)> FindCell;
};

/**
 * Warnings: one counts points that are at most 1e-6 of the diagonal of all apart, names two of
 * them, and tells the cure; another one counts points that hang (FlatPart.h) so that an edge lies
 * along the edge or face of another cell, and names the first of these cells. None if no cells
 * would be joined: parts that touch at a point only, and cells without a size, are no reason to
 * warn.
 *
 * Only open parts of the border can be joined: faces of one solid, edges of one face,
 * ends of lines; beside tetrahedra, all triangles and lines that are no part of them. They may hang
 * on each other, on surfaces on any face. Other points, most of a solid, need no search. Takes a
 * step for each face or edge, and n log n for n open points; some 100 bytes for each of these.
 */
template <typename Id>
std::vector<std::string> DescribeOpenPoints(const SimplicialComplex<Id>& complex,
  const Coordinates& coordinates, const OpenPointOptions& options);
template <typename Id>
std::vector<std::string> DescribeOpenPoints(
  const CellComplex<Id>& complex, const Coordinates& coordinates, const OpenPointOptions& options);
template <typename Id>
std::vector<std::string> DescribeOpenPointsOfSurface(
  const PolygonMesh<Id>& mesh, const Coordinates& coordinates, const OpenPointOptions& options);

}

#endif
