// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Arrays/MatrixArrays.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

namespace subdivision
{
namespace
{

template <typename Value, typename Array>
void WriteValues(const Buffer<Value>& values, Array* array)
{
  array->SetNumberOfComponents(1);
  CopyInThreads(values.data(), values.size(), array->WritePointer(0, values.size()));
  array->Modified();
}

}

void WriteMatrix(const MatrixFactors::Matrix& matrix, vtkIdTypeArray* offsets, vtkIdTypeArray* ids,
  vtkDoubleArray* weights)
{
  WriteValues(matrix.Offsets, offsets);
  WriteValues(matrix.Columns, ids);
  WriteValues(matrix.Weights, weights);
}

}
