// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenSeams.h
 * Texture coordinates on both sides of seams that were joined before a mesh was refined.
 */
#ifndef SubdivisionObjects_RedGreenSeams_h
#define SubdivisionObjects_RedGreenSeams_h

#include "Private/RedGreen/RedGreenMesh.h"

#include <array>
#include <vector>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

/// Gives points on a seam a copy for each side beyond the first, and all points texture
/// coordinates, which are linear in each simplex of `mesh`. `joined`: the input that was read;
/// `torn`: the same cells before their sides were joined; `ends`: of the edges that new points
/// halve; `simplices`: of which each cell of the output is a part.
template <typename Id>
void TearSeams(vtkPointSet* torn, vtkPointSet* joined, const RedGreenMesh& mesh,
  const std::vector<std::array<Id, 2>>& ends, const std::vector<vtkIdType>& simplices,
  vtkUnstructuredGrid* output);

}

#endif
