// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ThirdsReader.h
 * The cells of a mesh of triangles and lines, and the parts into which two pairs of steps of the
 * sqrt(3) scheme split them.
 *
 * After two steps the edges of a triangle are cut into thirds, and nine triangles lie in it: six
 * around its centre, which the first step makes, and one at each corner (Mathematics 11).
 */
#ifndef SubdivisionObjects_ThirdsReader_h
#define SubdivisionObjects_ThirdsReader_h

#include "Private/Bounds/NestedPieces.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>

class vtkPointSet;

namespace subdivision
{

/// `getMesh` returns the mesh after none to four steps, or null after an error or a stop; then
/// there are no pieces. The pieces have no cells where it is not known how they are split: at fixed
/// edges that the first step cuts, and where a mesh has other cells than triangles, lines of one
/// piece and vertices.
std::unique_ptr<NestedPieces> ReadThirds(
  const std::function<vtkSmartPointer<vtkPointSet>(int steps)>& getMesh);

}

#endif
