// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutputNumbers.h
 * Numbers the points and cells of an output that is made of a part of a mesh as the output of the
 * whole mesh numbers them.
 */
#ifndef SubdivisionObjects_OutputNumbers_h
#define SubdivisionObjects_OutputNumbers_h

#include "Core/Solids/Scheme/Level.h"
#include "Private/Control/ControlMesh.h"

#include <vector>

class vtkPointSet;

namespace subdivision
{

class Partners;

struct OutputNumbers
{
  std::vector<vtkIdType> Points; ///< -1 far from own cells
  std::vector<vtkIdType> Cells;
  /// Of each control simplex, the number of its first cell in the output.
  std::vector<vtkIdType> FirstCells;
  /// Of each derived simplex, by its dimension, whether it is a face of an own cell: only then this
  /// partition is sure of it.
  std::vector<char> IsOwnDerived[3];
  // Of the whole:
  vtkIdType NumberOfControlPoints = 0;
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
};

/**
 * `mesh` is what was read from `input`, the mesh that `partners` know, `derived` the singular
 * simplices of its control mesh; the output is `steps` steps after that. All partitions call this
 * together.
 *
 * The ids of children follow from those of their parents by arithmetic. So it is enough to number
 * the vertices, edges, faces and tetrahedra of the control mesh, each kind with NumberTogether: 14
 * exchanges, however many steps there are. About 100 bytes are sent for each control tetrahedron.
 */
OutputNumbers NumberOutput(const ControlMesh& mesh, const SimplexTuples& derived,
  vtkPointSet* input, int steps, const SchemeTraits& scheme, Partners& partners);

}

#endif
