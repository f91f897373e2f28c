// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceCounts.h
 * Whether a mesh is one of triangles or of quads.
 */
#ifndef SubdivisionObjects_FaceCounts_h
#define SubdivisionObjects_FaceCounts_h

#include <array>

class vtkDataObject;

namespace subdivision
{

/// How many polygons have three points, and four or more; the same of the faces of solids. Numbers
/// that ranks can add.
using FaceCounts = std::array<double, 4>;

/// Whether quads and larger faces are the majority of the polygons or, where there are none, of the
/// faces of solids.
bool HasMostlyQuads(const FaceCounts& counts);

/// Counts the faces of a readable mesh, or of all blocks of a composite one: neither of cells that
/// are left out nor of duplicates, so that cells of all ranks count once. A strip has a triangle
/// for each edge inside it and one more; a face between two solids counts twice.
FaceCounts CountFaces(vtkDataObject* readable);

}

#endif
