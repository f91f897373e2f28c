// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TopologyNumbers.h
 * Numbers the points and cells of an output that is made of a part of a mesh as the output of the
 * whole mesh numbers them.
 */
#ifndef SubdivisionObjects_TopologyNumbers_h
#define SubdivisionObjects_TopologyNumbers_h

#include "Private/Control/ControlMesh.h"

#include <functional>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

class Partners;

/**
 * Adds the numbers as arrays to an output with the points of `mesh`, whose cells are vertices, then
 * edges, then triangles. `mesh` was read from `input`, the mesh that `partners` know; `isOwn`:
 * whether an output cell lies on an own cell of the input, others get -1.
 *
 * The whole output has the cells of each kind in the order of the numbers of their points, so that
 * NumberTogether finds their numbers: ten exchanges, with the ones for points.
 */
void AddTopologyNumbers(vtkPointSet* input, const ControlMesh& mesh,
  const std::function<bool(vtkIdType)>& isOwn, Partners& partners, vtkUnstructuredGrid* output);

}

#endif
