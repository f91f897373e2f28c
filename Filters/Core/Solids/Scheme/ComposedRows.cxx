// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/ComposedRows.h"

#include "Core/Memory/Ids.h"

namespace subdivision
{

template <typename Id>
SparseRows<int> Compose(const SparseRows<int>& rows, const Stencils<Id>& step)
{
  const vtkIdType size = step.GetNumberOfRows();
  constexpr vtkIdType byRule = -1;
  constexpr vtkIdType unused = -2;
  Buffer<vtkIdType> sources(size, unused); // of each row: one of these two, or an explicit row
  for (int column : rows.Columns)
  {
    sources[column] = byRule;
  }
  const ExplicitRows<Id>& explicitRows = step.Explicit;
  for (std::size_t i = 0; i < explicitRows.Rows.size(); ++i)
  {
    vtkIdType& source = sources[explicitRows.Rows[i]];
    source = source == byRule ? static_cast<vtkIdType>(i) : source;
  }
  ExplicitRows<Id> wanted;
  Buffer<int> offsets(size + 1);
  for (vtkIdType row = 0; row < size; ++row)
  {
    offsets[row] = static_cast<int>(wanted.Columns.size());
    if (sources[row] == byRule)
    {
      step.AppendRow(row, 1., wanted);
    }
    else if (sources[row] >= 0)
    {
      const Id begin = explicitRows.Offsets[sources[row]];
      const Id end = explicitRows.Offsets[sources[row] + 1];
      wanted.Columns.insert(wanted.Columns.end(), explicitRows.Columns.begin() + begin,
        explicitRows.Columns.begin() + end);
      wanted.Weights.insert(wanted.Weights.end(), explicitRows.Weights.begin() + begin,
        explicitRows.Weights.begin() + end);
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
