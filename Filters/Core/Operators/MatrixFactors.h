// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MatrixFactors.h
 * Operators as sparse matrices, for who computes with them elsewhere.
 *
 * Rows of rules and rings sum the values of a ring before they weight them (PointOperator.h). A
 * matrix with one weight for each value has other products and sums, and so rounds differently. So
 * such an operator is the product of two matrices: the first copies all values and adds sums of
 * some of them behind, the second weights these. Whoever multiplies with the factors one after the
 * other, and sums each row in the order of its entries, has the bits of the operator.
 */
#ifndef SubdivisionObjects_MatrixFactors_h
#define SubdivisionObjects_MatrixFactors_h

#include "Core/Operators/SparseRows.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace subdivision
{

class MatrixFactors
{
public:
  using Matrix = SparseRows<long long>;

  /// Appends one factor, or two for an operator with rows of rules and rings. Finite values only
  /// have the same bits, as long as no sum of them overflows. An operator with values between has
  /// no factors: std::invalid_argument is thrown.
  void Append(const PointOperator& operation);
  void Append(Matrix&& factor) { this->Factors.push_back(std::move(factor)); }

  /// The factors of one operator that was appended, from Begin to End.
  struct Operation
  {
    std::size_t Begin;
    std::size_t End;
  };
  const std::vector<Operation>& GetOperations() const { return this->Operations; }

  ///@{
  /// How many of the operators, from the first on, some crease is semi-sharp in: all after them are
  /// alike.
  void SetNumberOfSharpSteps(int steps) { this->NumberOfSharpSteps = steps; }
  int GetNumberOfSharpSteps() const { return this->NumberOfSharpSteps; }
  ///@}

  /// The first factor is applied first.
  const std::vector<Matrix>& Get() const { return this->Factors; }
  vtkIdType GetNumberOfRows() const
  {
    return this->Factors.empty() ? 0 : this->Factors.back().GetNumberOfRows();
  }
  vtkIdType GetNumberOfColumns() const
  {
    return this->Factors.empty() ? 0 : this->Factors.front().GetNumberOfColumns();
  }
  /// The product of all factors, of which there must be one. It rounds otherwise than they do.
  Matrix Multiply() const;

private:
  std::vector<Matrix> Factors;
  std::vector<Operation> Operations;
  int NumberOfSharpSteps = 0;
};

}

#endif
