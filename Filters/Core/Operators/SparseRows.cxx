// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/SparseRows.h"

#include "Core/Memory/ScalarTypes.h"
#include "Core/Memory/Store.h"

#include <unordered_map>
#include <vector>

namespace subdivision
{

namespace
{

template <typename In, typename Out>
Out CopyValue(In value)
{
  if constexpr (std::is_same<In, Out>::value)
  {
    return value;
  }
  else
  {
    return Store<Out>(static_cast<double>(value));
  }
}

/// N > 0: there are N components, which are summed together. N = 0: `components` are summed one
/// after another.
template <int N, typename Id, typename In, typename Out>
void ApplyRows(const SparseRows<Id>& rows, const In* in, Out* out, int components)
{
  constexpr int width = N == 0 ? 1 : N;
  ForRanges(rows.GetNumberOfRows(),
    [&](vtkIdType first, vtkIdType last)
    {
      const int stride = N == 0 ? components : N;
      const Id* offsets = rows.Offsets.data();
      const Id* columns = rows.Columns.data();
      const double* weights = rows.Weights.data();
      for (vtkIdType row = first; row < last; ++row)
      {
        const vtkIdType begin = offsets[row];
        const vtkIdType end = offsets[row + 1];
        Out* result = out + row * stride;
        if (end - begin == 1 && weights[begin] == 1.)
        {
          const In* own = in + static_cast<vtkIdType>(columns[begin]) * stride;
          std::transform(own, own + stride, result, CopyValue<In, Out>);
          continue;
        }
        for (int c = 0; c < stride; c += width)
        {
          double sums[width] = {};
          for (vtkIdType k = begin; k < end; ++k)
          {
            const double weight = weights[k];
            if (weight == 0.) // 0 times a value that is not finite is not 0
            {
              continue;
            }
            const In* value = in + static_cast<vtkIdType>(columns[k]) * stride + c;
            for (int i = 0; i < width; ++i)
            {
              sums[i] += weight * static_cast<double>(value[i]);
            }
          }
          std::transform(sums, sums + width, result + c, Store<Out>);
        }
      }
    });
}

}

template <typename Id>
template <typename In, typename Out>
void SparseRows<Id>::Apply(const In* in, Out* out, int components) const
{
  components == 3 ? ApplyRows<3>(*this, in, out, 3) : ApplyRows<0>(*this, in, out, components);
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
#define SUBDIVISION_APPLY_TO(Id, In, Out)                                                          \
  template void SparseRows<Id>::Apply(const In*, Out*, int) const
#define SUBDIVISION_SPARSE_ROWS(Id)                                                                \
  template struct SparseRows<Id>;                                                                  \
  template SparseRows<Id> Multiply(const SparseRows<Id>&, const SparseRows<Id>&);                  \
  SUBDIVISION_APPLY_TO(Id, double, float);                                                         \
  SUBDIVISION_FOR_SCALARS(SUBDIVISION_APPLY, Id)
SUBDIVISION_SPARSE_ROWS(int);
SUBDIVISION_SPARSE_ROWS(long long);

}
