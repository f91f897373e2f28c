// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RowBlock.h
 * A few rows of an operator, which are used as soon as they are made. They stay in the processor's
 * cache, so that an operator whose rows are cheap to make need not be stored.
 */
#ifndef SubdivisionObjects_RowBlock_h
#define SubdivisionObjects_RowBlock_h

#include "Core/Operators/ApplyRows.h"

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
  void EndRow() { this->Offsets.push_back(static_cast<Id>(this->Size)); }
  void Clear()
  {
    this->Size = 0;
    this->Offsets.resize(1);
  }

  std::size_t GetNumberOfRows() const { return this->Offsets.size() - 1; }
  std::size_t GetNumberOfEntries() const { return this->Size; }
  std::size_t GetBegin(std::size_t row) const
  {
    return static_cast<std::size_t>(this->Offsets[row]);
  }
  std::size_t GetEnd(std::size_t row) const
  {
    return static_cast<std::size_t>(this->Offsets[row + 1]);
  }
  const Id* GetColumns() const { return this->Columns.data(); }
  const double* GetWeights() const { return this->Weights.data(); }

  /// The rows as those from row `first` on of an operator.
  WeightedRows<Id> GetRows(vtkIdType first) const
  {
    return { first, static_cast<vtkIdType>(this->GetNumberOfRows()), this->Offsets.data(),
      this->Columns.data(), this->Weights.data() };
  }
  /// out = S in for these rows, with `components` interleaved values per column.
  void Apply(const double* in, double* out, int components) const
  {
    SumRows(this->GetRows(0), in, out, components);
  }

private:
  std::vector<Id> Columns;
  std::vector<double> Weights;
  std::vector<Id> Offsets{ Id(0) };
  std::size_t Size = 0;
};

}

#endif
