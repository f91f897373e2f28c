// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OperatorSequence.h
 * Operators that are applied one after the other, such as the operators of all steps. Who keeps
 * them need not know how they are stored.
 */
#ifndef SubdivisionObjects_OperatorSequence_h
#define SubdivisionObjects_OperatorSequence_h

#include "Core/Operators/SparseRows.h"

#include <utility>
#include <vector>

namespace subdivision
{

class OperatorSequence
{
public:
  virtual ~OperatorSequence() = default;
  /// Applies the operators to `components` numbers for each column of the first one. The memory of
  /// an earlier `result` is reused, because clearing new pages takes time.
  virtual void Apply(const double* values, int components, Buffer<double>& result) const = 0;
  /// Turns rows over the values after the last operator into rows over the values before the first.
  virtual SparseRows<int> ComposeWith(const SparseRows<int>& rows) const = 0;
  virtual std::size_t GetMemorySize() const = 0;
};

/// Apply for a vector of operators of one type, which must not be empty.
template <typename Operator>
void ApplyInSequence(const std::vector<Operator>& operators, const double* values, int components,
  Buffer<double>& result)
{
  Buffer<double> current;
  for (std::size_t i = 0; i < operators.size(); ++i)
  {
    const vtkIdType size = components * operators[i].GetNumberOfRows();
    // NOLINTNEXTLINE(bugprone-use-after-move): it is moved in the last turn only
    const bool isReused = i + 1 == operators.size() && result.size() == size;
    Buffer<double> next = isReused ? std::move(result) : Buffer<double>(size);
    operators[i].Apply(i == 0 ? values : current.data(), next.data(), components);
    current = std::move(next);
  }
  result = std::move(current);
}

/// A sequence of rows with weights, at least one.
class StoredSequence : public OperatorSequence
{
public:
  explicit StoredSequence(std::vector<SparseRows<int>>&& operators)
    : Operators(std::move(operators))
  {
  }
  void Apply(const double* values, int components, Buffer<double>& result) const override
  {
    ApplyInSequence(this->Operators, values, components, result);
  }
  SparseRows<int> ComposeWith(const SparseRows<int>& rows) const override
  {
    SparseRows<int> composed = Multiply(rows, this->Operators.back());
    for (auto inner = this->Operators.rbegin() + 1; inner != this->Operators.rend(); ++inner)
    {
      composed = Multiply(composed, *inner);
    }
    return composed;
  }
  std::size_t GetMemorySize() const override
  {
    std::size_t bytes = 0;
    for (const SparseRows<int>& rows : this->Operators)
    {
      bytes += rows.GetMemorySize();
    }
    return bytes;
  }

private:
  std::vector<SparseRows<int>> Operators;
};

}

#endif
