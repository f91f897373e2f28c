// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/DirectSolver.h"

#include "Core/Memory/Loops.h"

#define EIGEN_MPL2_ONLY // nothing under another licence
#include <Eigen/SparseLU>

#include <limits>

namespace subdivision
{
namespace
{

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Ordering = Eigen::COLAMDOrdering<int>;

constexpr double Shift = 1e-12;
constexpr double MostOperations = 1e11; ///< some 30 s, in which nothing can be stopped
/// Bytes of both factors for each entry of one; arrays that grow are copied.
constexpr double BytesOfEntry = 64.;

/// Whether the factors fit. Without pivots they have the entries of the factors of the symmetric
/// pattern, which are counted along the paths of the elimination tree.
bool Fits(const Matrix& matrix, double mostBytes)
{
  Ordering::PermutationType order;
  Ordering()(matrix, order);
  Matrix pattern(matrix.rows(), matrix.cols());
  pattern = (Matrix(matrix.transpose()) + matrix).twistedBy(order);
  const auto size = static_cast<std::size_t>(matrix.cols());
  std::vector<int> parents(size, -1);
  std::vector<int> visited(size, -1);
  std::vector<double> counts(size, 1.);
  const double most = std::min(mostBytes / BytesOfEntry, std::numeric_limits<int>::max() / 4.);
  double entries = 0.;
  for (const std::size_t column : InTurn(size))
  {
    const int last = static_cast<int>(column);
    visited[column] = last;
    for (Matrix::InnerIterator entry(pattern, last); entry; ++entry)
    {
      for (int row = static_cast<int>(entry.index()); row < last && visited[row] != last;
        row = parents[row])
      {
        parents[row] = parents[row] < 0 ? last : parents[row];
        visited[row] = last;
        counts[row] += 1.;
        entries += 1.;
      }
    }
    if (entries > most)
    {
      return false;
    }
  }
  double operations = 0.;
  for (const double count : counts)
  {
    operations += 2. * count * count;
  }
  return operations <= MostOperations;
}

}

struct DirectSolver::Factors
{
  Eigen::SparseLU<Matrix, Ordering> Both;
};

DirectSolver::DirectSolver() = default;
DirectSolver::~DirectSolver() = default;

bool DirectSolver::Factorise(vtkIdType size, const std::vector<double>& rows, double mostBytes)
{
  this->Own = nullptr;
  constexpr double mostEntries = std::numeric_limits<int>::max() / 4.;
  constexpr double bytesOfInput = 100.; // of an entry, in all copies of the matrix
  const double given = static_cast<double>(rows.size()) / 2.;
  if (static_cast<double>(size) > mostEntries || given > mostEntries ||
    bytesOfInput * given > mostBytes)
  {
    return false;
  }
  std::vector<Eigen::Triplet<double, int>> entries;
  std::vector<char> isKnown(static_cast<std::size_t>(size), 0);
  for (std::size_t at = 0; at < rows.size();)
  {
    const int row = static_cast<int>(rows[at]);
    const std::size_t end = at + 2 + 2 * static_cast<std::size_t>(rows[at + 1]);
    for (at += 2; at < end; at += 2)
    {
      if (!isKnown[row])
      {
        entries.emplace_back(row, static_cast<int>(rows[at]), rows[at + 1]);
      }
    }
    isKnown[row] = 1;
  }
  for (const vtkIdType row : InTurn(size))
  {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(row), isKnown[row] ? Shift : 1.);
  }
  Matrix matrix(static_cast<int>(size), static_cast<int>(size));
  matrix.setFromTriplets(entries.begin(), entries.end());
  entries = {};
  if (!Fits(matrix, mostBytes - bytesOfInput * given))
  {
    return false;
  }
  this->Own = std::make_unique<Factors>();
  this->Own->Both.compute(matrix);
  return true;
}

void DirectSolver::Solve(std::vector<double>& values) const
{
  Eigen::Map<Eigen::VectorXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
  if (this->Own && this->Own->Both.info() == Eigen::Success)
  {
    all = this->Own->Both.solve(Eigen::VectorXd(all));
  }
  else
  {
    all.setZero();
  }
}

}
