// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenNumbers.h
 * Numbers the points and cells of an output that is made of a part of a mesh as the output of the
 * whole mesh numbers them.
 */
#ifndef SubdivisionObjects_RedGreenNumbers_h
#define SubdivisionObjects_RedGreenNumbers_h

#include "Private/Control/Partners.h"
#include "Private/RedGreen/RedGreenMesh.h"

namespace subdivision
{

/**
 * Adds the numbers as arrays to the output of a state whose vertices are sorted; points far from
 * own cells get -1. `mesh` is what was read from `input`, the mesh that `partners` know, and
 * `simplices` are those of which each cell of the output is a part. All partitions call this
 * together. Returns how many points and cells the whole output has.
 *
 * A new vertex is known by the numbers of the ends of its edge, so that those of each number of
 * halvings are numbered after those of less: two exchanges for each, of 24 bytes for each vertex.
 */
template <typename Id>
WholeSize AddRedGreenNumbers(vtkPointSet* input, const RedGreenMesh& mesh,
  const RedGreen<Id>& state, const std::vector<vtkIdType>& simplices, Partners& partners,
  vtkUnstructuredGrid* output);

}

#endif
