// SPDX-License-Identifier: BSD-3-Clause
#include "SparseRows.h"

#include "Store.h"

#include <unordered_map>
#include <vector>

namespace subdivision
{

template <typename Id>
template <typename T>
void SparseRows<Id>::Apply(const T* in, T* out, int components) const
{
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        const vtkIdType begin = this->Offsets[row];
        const vtkIdType end = this->Offsets[row + 1];
        T* result = out + row * components;
        if (end - begin == 1 && this->Weights[begin] == 1.)
        {
          const T* own = in + static_cast<vtkIdType>(this->Columns[begin]) * components;
          std::copy(own, own + components, result);
          continue;
        }
        for (int c = 0; c < components; ++c)
        {
          double sum = 0.;
          for (vtkIdType k = begin; k < end; ++k)
          {
            if (this->Weights[k] != 0.) // values that are not finite must not spread
            {
              sum += this->Weights[k] *
                static_cast<double>(in[static_cast<vtkIdType>(this->Columns[k]) * components + c]);
            }
          }
          result[c] = Store<T>(sum);
        }
      }
    });
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

#define SUBDIVISION_APPLY(Id, T) template void SparseRows<Id>::Apply(const T*, T*, int) const
#define SUBDIVISION_SPARSE_ROWS(Id)                                                                \
  template struct SparseRows<Id>;                                                                  \
  template SparseRows<Id> Multiply(const SparseRows<Id>&, const SparseRows<Id>&);                  \
  SUBDIVISION_APPLY(Id, float);                                                                    \
  SUBDIVISION_APPLY(Id, double);                                                                   \
  SUBDIVISION_APPLY(Id, char);                                                                     \
  SUBDIVISION_APPLY(Id, signed char);                                                              \
  SUBDIVISION_APPLY(Id, unsigned char);                                                            \
  SUBDIVISION_APPLY(Id, short);                                                                    \
  SUBDIVISION_APPLY(Id, unsigned short);                                                           \
  SUBDIVISION_APPLY(Id, int);                                                                      \
  SUBDIVISION_APPLY(Id, unsigned int);                                                             \
  SUBDIVISION_APPLY(Id, long);                                                                     \
  SUBDIVISION_APPLY(Id, unsigned long);                                                            \
  SUBDIVISION_APPLY(Id, long long);                                                                \
  SUBDIVISION_APPLY(Id, unsigned long long)
SUBDIVISION_SPARSE_ROWS(int);
SUBDIVISION_SPARSE_ROWS(long long);

}
