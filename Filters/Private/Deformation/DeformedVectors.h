// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeformedVectors.h
 * Transforms vectors and normals of a deformed data set by the derivatives of the deformation.
 */
#ifndef SubdivisionObjects_DeformedVectors_h
#define SubdivisionObjects_DeformedVectors_h

#include "Core/Memory/Buffer.h"

class vtkPointSet;

namespace subdivision
{

struct RunOptions;

/// Whether there are active vectors, tangents or normals, of floating type, at points or cells.
bool HasVectors(vtkPointSet* data);

/**
 * Transforms the active vectors, tangents and normals of the output, which the input had before.
 * `jacobians` has the Jacobian matrix of the deformation for each point: 9 numbers, row by row. A
 * cell takes the mean of its points. Vectors and tangents are multiplied by the matrix, normals by
 * its inverse transpose, and normals get the length 1. A warning names the cells that cannot be
 * read, of which the vectors stay as they are.
 */
void TransformVectors(
  const Buffer<double>& jacobians, const RunOptions& options, vtkPointSet* output);

}

#endif
