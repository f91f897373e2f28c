// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/CornerRows.h"

#include "Core/Memory/Ahead.h"
#include "Core/Memory/Store.h"
#include "Core/Operators/ForBlocks.h"

namespace subdivision
{

void CornerRows::ForEachBlock(const User& use) const
{
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType from, vtkIdType to)
    {
      std::array<CornerRow, BlockSize> rows;
      ForBlocks(from, to,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType i = begin; i < end; ++i)
          {
            this->Complete(i, rows[i - begin]);
          }
          use(RowsOfFour{ begin, end - begin, rows.data() });
        });
    });
}

namespace
{

template <typename Out>
void MovePoint(const double* weights, const int* columns, const double* points, Out* moved)
{
  double sums[3] = {};
  for (int k = 0; k < 4; ++k)
  {
    const double* corner = points + 3 * static_cast<vtkIdType>(columns[k]);
    for (int c = 0; c < 3; ++c)
    {
      sums[c] += weights[k] * corner[c];
    }
  }
  std::transform(sums, sums + 3, moved, Store<Out>);
}

}

template <typename Out>
void CornerRows::Move(vtkIdType begin, vtkIdType end, const double* points, Out* moved) const
{
  constexpr vtkIdType ahead = 400; // weights
  for (vtkIdType i = begin; i < end; ++i)
  {
    const int simplex = this->Simplices[i];
    if (simplex < 0)
    {
      const CornerRow& row = this->Others[-1 - simplex];
      MovePoint(row.Weights, row.Columns, points, moved + 3 * i);
      continue;
    }
    AskFor(this->Weights.data(), 3 * i + ahead);
    MovePoint(CompleteWeights(this->Weights.data() + 3 * i).data(),
      this->Corners + 4 * static_cast<vtkIdType>(simplex), points, moved + 3 * i);
  }
}

template <typename Out>
void CornerRows::Move(const double* points, Out* moved) const
{
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType begin, vtkIdType end) { this->Move(begin, end, points, moved); });
}

template void CornerRows::Move(const double*, float*) const;
template void CornerRows::Move(const double*, double*) const;
template void CornerRows::Move(vtkIdType, vtkIdType, const double*, float*) const;
template void CornerRows::Move(vtkIdType, vtkIdType, const double*, double*) const;

SparseRows<int> CornerRows::ToSparseRows() const
{
  const vtkIdType size = this->GetNumberOfRows();
  SparseRows<int> rows;
  rows.NumberOfColumns = this->NumberOfColumns;
  rows.Offsets = Buffer<int>(size + 1);
  ForEach(size,
    [&](vtkIdType i)
    {
      CornerRow row;
      this->Complete(i, row);
      rows.Offsets[i] = 4 - static_cast<int>(std::count(row.Weights, row.Weights + 4, 0.));
    });
  CountsToOffsets(rows.Offsets);
  rows.Columns = Buffer<int>(rows.Offsets[size]);
  rows.Weights = Buffer<double>(rows.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      const CornerRow row = this->GetRow(i);
      vtkIdType entry = rows.Offsets[i];
      for (int k = 0; k < 4; ++k)
      {
        if (row.Weights[k] != 0.)
        {
          rows.Columns[entry] = row.Columns[k];
          rows.Weights[entry++] = row.Weights[k];
        }
      }
    });
  return rows;
}

}
