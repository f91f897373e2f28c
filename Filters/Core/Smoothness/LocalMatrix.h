// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalMatrix.h
 * A step at a vertex and its neighbourhood as a small dense matrix, and its eigenvalues.
 */
#ifndef SubdivisionObjects_LocalMatrix_h
#define SubdivisionObjects_LocalMatrix_h

#include <cstddef>
#include <vector>

namespace subdivision
{

class LocalMatrix
{
public:
  /// Larger matrices are not made: time grows with the third power, and nothing stops the algebra.
  static constexpr int MostItems = 600;

  explicit LocalMatrix(int size = 0)
    : Size(size)
    , Values(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.)
  {
  }

  int GetSize() const { return this->Size; }
  double& At(int row, int column) { return this->Values[this->Find(row, column)]; }
  double At(int row, int column) const { return this->Values[this->Find(row, column)]; }

  /// The moduli of the eigenvalues, the largest first. Empty if they were not found.
  std::vector<double> FindModuli() const;

  /// A basis of the space of the eigenvalues 1 to `count`, where the one with the largest modulus
  /// is number 0: `count` numbers for each row. Empty if an eigenvalue of a complex pair would be
  /// missing.
  std::vector<double> FindLeading(int count) const;

  /// The rows of the first `known` items read no others. Continues a basis of their leading
  /// eigenvectors to all items. Empty where that is not possible.
  std::vector<double> Continue(int known, const std::vector<double>& basis, int count) const;

private:
  std::size_t Find(int row, int column) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Size) +
      static_cast<std::size_t>(column);
  }

  int Size;
  std::vector<double> Values; ///< row by row
};

}

#endif
