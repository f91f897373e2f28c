// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MarkGeometry.h
 * Marks by geometry that lies on the mesh: its vertices, lines and polygons name vertices, edges
 * and triangles of the mesh.
 */
#ifndef SubdivisionObjects_MarkGeometry_h
#define SubdivisionObjects_MarkGeometry_h

#include "Private/Run/Marks.h"

namespace subdivision
{

/// Adds the simplices of `mesh`, which was read from `input`, that are cells of options.Geometry.
/// Its polygons are cut as polygons of the mesh; lines have the sharpness of its cell array
/// `Sharpness`, if there is one. `warn` is told of cells that lie on none.
void MarkGeometry(vtkPointSet* input, const SimplexView& mesh, const MarkOptions& options,
  const std::function<void(const std::string&)>& warn, SharpTuples& tuples);

}

#endif
