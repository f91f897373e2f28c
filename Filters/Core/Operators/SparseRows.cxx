// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/SparseRows.h"

#include "Core/Memory/Ids.h"

#include <unordered_map>
#include <vector>

namespace subdivision
{

template <typename Id>
WeightedRows<Id> SparseRows<Id>::GetRows(vtkIdType begin, vtkIdType end) const
{
  WeightedRows<Id> rows{ begin, end - begin, this->Offsets.data() + begin, this->Columns.data(),
    this->Weights.data() };
  rows.SkipsZeros = true;
  return rows;
}

template <typename Id>
void SparseRows<Id>::ForEachBlock(const User& use) const
{
  // No smaller blocks: the rows are read from memory in any case, and an array that is summed alone
  // stays in the cache.
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType begin, vtkIdType end) { use(this->GetRows(begin, end)); });
}

namespace
{

/// Sums entries by column; columns come out in the order in which they first came.
template <typename Id>
class RowSum
{
public:
  void Add(Id column, double weight)
  {
    const auto [at, isNew] = this->Places.emplace(column, this->Columns.size());
    if (isNew)
    {
      this->Columns.push_back(column);
      this->Weights.push_back(weight);
    }
    else
    {
      this->Weights[at->second] += weight;
    }
  }
  void Clear()
  {
    this->Places.clear();
    this->Columns.clear();
    this->Weights.clear();
  }

  std::vector<Id> Columns;
  std::vector<double> Weights;

private:
  std::unordered_map<Id, std::size_t> Places;
};

}

template <typename Id>
SparseRows<Id> Multiply(const SparseRows<Id>& outer, const SparseRows<Id>& inner)
{
  SparseRows<Id> product;
  product.NumberOfColumns = inner.NumberOfColumns;
  const vtkIdType rows = outer.GetNumberOfRows();
  auto sumRow = [&](vtkIdType row, RowSum<Id>& sum)
  {
    sum.Clear();
    for (vtkIdType k = outer.Offsets[row]; k < outer.Offsets[row + 1]; ++k)
    {
      const vtkIdType middle = outer.Columns[k];
      for (vtkIdType j = inner.Offsets[middle]; j < inner.Offsets[middle + 1]; ++j)
      {
        sum.Add(inner.Columns[j], outer.Weights[k] * inner.Weights[j]);
      }
    }
  };
  product.Offsets = Buffer<Id>(rows + 1);
  ForRanges(rows,
    [&](vtkIdType first, vtkIdType last)
    {
      RowSum<Id> sum;
      for (vtkIdType row = first; row < last; ++row)
      {
        sumRow(row, sum);
        product.Offsets[row] = static_cast<Id>(sum.Columns.size());
      }
    });
  CountsToOffsets(product.Offsets);
  product.Columns = Buffer<Id>(product.Offsets[rows]);
  product.Weights = Buffer<double>(product.Offsets[rows]);
  ForRanges(rows,
    [&](vtkIdType first, vtkIdType last)
    {
      RowSum<Id> sum;
      for (vtkIdType row = first; row < last; ++row)
      {
        sumRow(row, sum);
        std::copy(
          sum.Columns.begin(), sum.Columns.end(), product.Columns.begin() + product.Offsets[row]);
        std::copy(
          sum.Weights.begin(), sum.Weights.end(), product.Weights.begin() + product.Offsets[row]);
      }
    });
  return product;
}

SUBDIVISION_COMPILE(struct SparseRows);
SUBDIVISION_COMPILE_FUNCTION(Multiply);

}
