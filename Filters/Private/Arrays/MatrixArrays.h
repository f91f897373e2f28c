// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MatrixArrays.h
 * Writes sparse matrices to arrays of VTK.
 */
#ifndef SubdivisionObjects_MatrixArrays_h
#define SubdivisionObjects_MatrixArrays_h

#include "Core/Operators/MatrixFactors.h"

class vtkDoubleArray;
class vtkIdTypeArray;

namespace subdivision
{

void WriteMatrix(const MatrixFactors::Matrix& matrix, vtkIdTypeArray* offsets, vtkIdTypeArray* ids,
  vtkDoubleArray* weights);

}

#endif
