// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/ComposedRows.h"

#include "Core/Memory/Ids.h"

namespace subdivision
{

template <typename Id>
SparseRows<int> Compose(const SparseRows<int>& rows, const Stencils<Id>& step)
{
  const vtkIdType size = step.GetNumberOfRows();
  Buffer<unsigned char> isUsed(size, 0);
  for (int column : rows.Columns)
  {
    isUsed[column] = 1;
  }
  ExplicitRows<Id> wanted;
  Buffer<int> offsets(size + 1);
  for (vtkIdType row = 0; row < size; ++row)
  {
    offsets[row] = static_cast<int>(wanted.Columns.size());
    if (isUsed[row])
    {
      step.AppendRow(row, 1., wanted);
    }
  }
  offsets[size] = static_cast<int>(wanted.Columns.size());
  SparseRows<int> inner;
  inner.NumberOfColumns = step.GetNumberOfColumns();
  inner.Offsets = std::move(offsets);
  inner.Columns = Buffer<int>(static_cast<vtkIdType>(wanted.Columns.size()));
  inner.Weights = Buffer<double>(static_cast<vtkIdType>(wanted.Weights.size()));
  std::transform(wanted.Columns.begin(), wanted.Columns.end(), inner.Columns.begin(),
    [](Id column) { return static_cast<int>(column); });
  std::copy(wanted.Weights.begin(), wanted.Weights.end(), inner.Weights.begin());
  return Multiply(rows, inner);
}

SUBDIVISION_COMPILE_FUNCTION(Compose);

}
