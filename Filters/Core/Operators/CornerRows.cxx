// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/CornerRows.h"

#include "Core/Memory/Store.h"

namespace subdivision
{

template <typename Out>
void CornerRows::Apply(const double* in, Out* out) const
{
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType begin, vtkIdType end)
    {
      const CornerRow* row = this->Rows.data() + begin;
      Out* to = out + 3 * begin;
      for (vtkIdType i = begin; i < end; ++i, ++row, to += 3)
      {
        double sums[3] = { 0., 0., 0. };
        for (int k = 0; k < 4; ++k)
        {
          const double weight = row->Weights[k];
          const double* corner = in + 3 * static_cast<vtkIdType>(row->Columns[k]);
          for (int c = 0; c < 3; ++c)
          {
            sums[c] += weight * corner[c];
          }
        }
        std::transform(sums, sums + 3, to, Store<Out>);
      }
    });
}

SparseRows<int> CornerRows::ToSparseRows() const
{
  const vtkIdType size = this->GetNumberOfRows();
  SparseRows<int> rows;
  rows.NumberOfColumns = this->NumberOfColumns;
  rows.Offsets = Buffer<int>(size + 1);
  ForEach(size,
    [&](vtkIdType i)
    {
      const double* weights = this->Rows[i].Weights;
      rows.Offsets[i] = 4 - static_cast<int>(std::count(weights, weights + 4, 0.));
    });
  CountsToOffsets(rows.Offsets);
  rows.Columns = Buffer<int>(rows.Offsets[size]);
  rows.Weights = Buffer<double>(rows.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      vtkIdType entry = rows.Offsets[i];
      for (int k = 0; k < 4; ++k)
      {
        if (this->Rows[i].Weights[k] != 0.)
        {
          rows.Columns[entry] = this->Rows[i].Columns[k];
          rows.Weights[entry++] = this->Rows[i].Weights[k];
        }
      }
    });
  return rows;
}

template void CornerRows::Apply(const double*, float*) const;
template void CornerRows::Apply(const double*, double*) const;

}
