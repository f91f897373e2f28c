// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ControlCounts.h
 * How many cells there are before the first level: for programs that tell what a filter makes.
 */
#ifndef SubdivisionObjects_ControlCounts_h
#define SubdivisionObjects_ControlCounts_h

#include <array>

class vtkDataObject;

namespace subdivision
{

/// Vertices, lines, triangles and tetrahedra, corners of polygons, and cells of any kind; then of
/// cells that keep their types faces, pyramids, and other solids.
using ControlCounts = std::array<double, 9>;

/// Counts the cells of a data set, or of all blocks; zero for null.
ControlCounts CountControlCells(vtkDataObject* data);

}

#endif
