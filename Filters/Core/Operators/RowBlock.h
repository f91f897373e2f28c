// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RowBlock.h
 * A few rows of an operator, which are used as soon as they are made. They stay in the processor's
 * cache, so that an operator whose rows are cheap to make need not be stored.
 */
#ifndef SubdivisionObjects_RowBlock_h
#define SubdivisionObjects_RowBlock_h

#include "Core/Memory/ScalarTypes.h"
#include "Core/Memory/Store.h"
#include "Core/Operators/SparseRows.h"

#include <vector>

namespace subdivision
{

template <typename Id>
class RowBlock
{
public:
  /// Adds an entry to the row that is being made.
  void Add(vtkIdType column, double weight)
  {
    if (this->Size == this->Columns.size())
    {
      this->Columns.resize(2 * this->Size + 64);
      this->Weights.resize(this->Columns.size());
    }
    this->Columns[this->Size] = static_cast<Id>(column);
    this->Weights[this->Size] = weight;
    ++this->Size;
  }
  void SetWeight(std::size_t entry, double weight) { this->Weights[entry] = weight; }
  void EndRow() { this->Ends.push_back(this->Size); }
  void Clear()
  {
    this->Size = 0;
    this->Ends.clear();
  }

  std::size_t GetNumberOfRows() const { return this->Ends.size(); }
  std::size_t GetNumberOfEntries() const { return this->Size; }
  std::size_t GetBegin(std::size_t row) const { return row ? this->Ends[row - 1] : 0; }
  std::size_t GetEnd(std::size_t row) const { return this->Ends[row]; }
  const Id* GetColumns() const { return this->Columns.data(); }
  const double* GetWeights() const { return this->Weights.data(); }

  /// out = S in for these rows, with `components` interleaved values per column. A row whose only
  /// entry has weight 1 copies.
  template <typename T>
  void Apply(const T* in, T* out, int components) const
  {
    ForComponents<T>(components,
      [&](auto size) { this->template Apply<decltype(size)::value>(in, out, components); });
  }

  /// N components; N = 0: their number is known at run time only.
  template <int N, typename T>
  void Apply(const T* in, T* out, int components) const;

private:
  std::vector<Id> Columns;
  std::vector<double> Weights;
  std::vector<std::size_t> Ends;
  std::size_t Size = 0;
};

template <typename Id>
template <int N, typename T>
void RowBlock<Id>::Apply(const T* in, T* out, int components) const
{
  const vtkIdType stride = N ? N : components;
  std::size_t k = 0;
  for (const std::size_t end : this->Ends)
  {
    if (end - k == 1 && this->Weights[k] == 1.)
    {
      const T* own = in + static_cast<vtkIdType>(this->Columns[k++]) * stride;
      out = std::copy(own, own + stride, out);
      continue;
    }
    if constexpr (N > 0)
    {
      double sums[N] = {};
      for (; k < end; ++k)
      {
        const double weight = this->Weights[k];
        const T* value = in + static_cast<vtkIdType>(this->Columns[k]) * N;
        for (int c = 0; c < N; ++c)
        {
          sums[c] += weight * static_cast<double>(value[c]);
        }
      }
      for (int c = 0; c < N; ++c)
      {
        *out++ = Store<T>(sums[c]);
      }
    }
    else
    {
      for (int c = 0; c < components; ++c)
      {
        double sum = 0.;
        for (std::size_t i = k; i < end; ++i)
        {
          sum += this->Weights[i] *
            static_cast<double>(in[static_cast<vtkIdType>(this->Columns[i]) * stride + c]);
        }
        *out++ = Store<T>(sum);
      }
      k = end;
    }
  }
}

}

#endif
