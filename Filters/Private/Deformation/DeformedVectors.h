// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeformedVectors.h
 * Vectors and normals of a deformed data set, by the derivatives of the map.
 */
#ifndef SubdivisionObjects_DeformedVectors_h
#define SubdivisionObjects_DeformedVectors_h

#include "Core/Memory/Buffer.h"

class vtkPointSet;

namespace subdivision
{

/// Whether there are active vectors, tangents or normals, of floating type, at points or cells.
bool HasVectors(vtkPointSet* data);

/**
 * Replaces those of the output, which are the input's so far. `jacobians` are 9 numbers for each
 * point, a matrix by rows; a cell takes the mean of its points'. Vectors and tangents are
 * multiplied by it, normals by its inverse transpose and made as long as 1.
 */
void TransformVectors(const Buffer<double>& jacobians, vtkPointSet* output);

}

#endif
