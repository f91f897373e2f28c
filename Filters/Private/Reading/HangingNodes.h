// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HangingNodes.h
 * Cells that do not fit, because a point of one lies inside an edge or a face of another.
 */
#ifndef SubdivisionObjects_HangingNodes_h
#define SubdivisionObjects_HangingNodes_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

/**
 * The mesh with cells that fit: a cell gets the points of others that lie on its edges
 * (FlatPart.h), and in the place of a face the faces of others that cover it. So lines become poly
 * lines, triangles, quads and polygons polygons, and solids polyhedra (PolyhedronFaces.h); cells
 * keep their ids, and points stay. Where a face of one cell and some faces of others overlap but do
 * not cover each other, where points lie inside of a face without a cell beyond, and for strips and
 * non-linear cells nothing can be done: a warning counts them. Returns the input where nothing
 * changes.
 *
 * Points that hang are searched among the points of faces that solids do not share, of edges of
 * surfaces that no two cells share, and of lines. Takes n log n steps, and 16 bytes for each face
 * of a solid.
 */
vtkSmartPointer<vtkPointSet> CloseHangingNodes(
  vtkPointSet* mesh, std::vector<std::string>& warnings);

}

#endif
