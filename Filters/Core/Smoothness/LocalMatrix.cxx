// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Smoothness/LocalMatrix.h"

#define EIGEN_MPL2_ONLY // nothing under another licence
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>

namespace subdivision
{
namespace
{

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Complex = std::complex<double>;

/// All eigenvalues, the largest modulus first.
std::vector<Complex> FindEigenvalues(const Eigen::MatrixXd& matrix)
{
  std::vector<Complex> found;
  if (matrix.rows() == 0)
  {
    return found;
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, false);
  if (solver.info() == Eigen::Success)
  {
    const auto& values = solver.eigenvalues();
    found.assign(values.data(), values.data() + values.size());
    std::stable_sort(found.begin(), found.end(),
      [](const Complex& a, const Complex& b) { return std::abs(a) > std::abs(b); });
  }
  return found;
}

/// The last columns of Q are orthogonal to the range of the transposed matrix, and so the matrix
/// takes them to zero. A singular value decomposition tells the same in twice the time to compile.
Eigen::MatrixXd FindNullSpace(const Eigen::MatrixXd& matrix, int dimension)
{
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(matrix.transpose());
  const Eigen::MatrixXd q = factors.householderQ();
  return q.rightCols(dimension);
}

Eigen::MatrixXd Copy(const double* values, Eigen::Index rows, Eigen::Index columns)
{
  return Eigen::Map<const RowMajor>(values, rows, columns);
}

std::vector<double> Store(const RowMajor& matrix)
{
  return { matrix.data(), matrix.data() + matrix.size() };
}

}

std::vector<double> LocalMatrix::FindModuli() const
{
  std::vector<double> moduli;
  for (const Complex& value : FindEigenvalues(Copy(this->Values.data(), this->Size, this->Size)))
  {
    moduli.push_back(std::abs(value));
  }
  return moduli;
}

std::vector<double> LocalMatrix::FindLeading(int count) const
{
  const Eigen::MatrixXd matrix = Copy(this->Values.data(), this->Size, this->Size);
  const std::vector<Complex> values = FindEigenvalues(matrix);
  if (static_cast<int>(values.size()) <= count)
  {
    return {};
  }
  // The product of all (A - l) takes the wanted vectors to zero, and no others. It is real, because
  // complex eigenvalues come in pairs.
  const auto unit = Eigen::MatrixXd::Identity(this->Size, this->Size);
  Eigen::MatrixXd product = unit;
  for (int i = 1; i <= count; ++i)
  {
    const Complex value = values[i];
    if (std::abs(value.imag()) < 1e-12)
    {
      product = (matrix - value.real() * unit) * product;
      continue;
    }
    if (++i > count)
    {
      return {};
    }
    product = (matrix * matrix - 2. * value.real() * matrix + std::norm(value) * unit) * product;
  }
  return Store(FindNullSpace(product, count));
}

/// With the basis X of the known items, A X = X B there. The others, Y, follow from
/// C X + D Y = Y B; with a triangular B that is one linear system for each column.
std::vector<double> LocalMatrix::Continue(
  int known, const std::vector<double>& basis, int count) const
{
  const Eigen::MatrixXd all = Copy(this->Values.data(), this->Size, this->Size);
  const Eigen::MatrixXd x = Copy(basis.data(), known, count);
  const int others = this->Size - known;
  const Eigen::MatrixXd b = x.colPivHouseholderQr().solve(all.topLeftCorner(known, known) * x);
  const Eigen::ComplexSchur<Eigen::MatrixXd> schur(b);
  if (schur.info() != Eigen::Success)
  {
    return {};
  }
  const Eigen::MatrixXcd given = all.bottomLeftCorner(others, known) * x * schur.matrixU();
  const Eigen::MatrixXcd outer = all.bottomRightCorner(others, others).cast<Complex>();
  Eigen::MatrixXcd y(others, count);
  for (int column = 0; column < count; ++column)
  {
    Eigen::VectorXcd right = -given.col(column);
    for (int before = 0; before < column; ++before)
    {
      right += schur.matrixT()(before, column) * y.col(before);
    }
    const Eigen::MatrixXcd system =
      outer - schur.matrixT()(column, column) * Eigen::MatrixXcd::Identity(others, others);
    y.col(column) = system.partialPivLu().solve(right);
  }
  RowMajor made(this->Size, count);
  made.topRows(known) = x;
  made.bottomRows(others) = (y * schur.matrixU().adjoint()).real();
  const double residual = (all * made - made * b).cwiseAbs().maxCoeff();
  const double size = made.cwiseAbs().maxCoeff();
  return std::isfinite(size) && residual < 1e-8 * size ? Store(made) : std::vector<double>();
}

}
