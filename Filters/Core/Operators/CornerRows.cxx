// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/CornerRows.h"

#include "Core/Operators/ForBlocks.h"

namespace subdivision
{

void CornerRows::ForEachBlock(const User& use) const
{
  ForBlocksInThreads(this->GetNumberOfRows(), [&](vtkIdType begin, vtkIdType end)
    { use(RowsOfFour{ begin, end - begin, this->Rows.data() + begin }); });
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

}
