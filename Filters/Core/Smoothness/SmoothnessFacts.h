// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmoothnessFacts.h
 * How smooth an object is at a place, as far as it is known, and the conditions on eigenvalues.
 */
#ifndef SubdivisionObjects_SmoothnessFacts_h
#define SubdivisionObjects_SmoothnessFacts_h

#include <array>
#include <vector>

namespace subdivision
{

/// An answer, which may be missing: there is no such condition there, or nothing was sampled.
enum class Answer : signed char
{
  None = -1,
  No = 0,
  Yes = 1
};

struct SmoothnessFacts
{
  static constexpr int NumberOfValues = 6;

  /// The moduli of the leading eigenvalues, the largest first; 0 where a matrix is too small.
  std::array<double, NumberOfValues> Eigenvalues{ { 1., 0., 0., 0., 0., 0. } };
  Answer Condition = Answer::None;
  Answer Regular = Answer::None;
  Answer Injective = Answer::None;
  int Samples = 0; ///< triangles or tetrahedra at which the characteristic map was looked at
  int Valence = 0;

  /// Whether something is known not to hold.
  bool Fails() const
  {
    return this->Condition == Answer::No || this->Regular == Answer::No ||
      this->Injective == Answer::No;
  }
  void SetEigenvalues(const std::vector<double>& moduli);
};

/// Eigenvalues that differ by less are equal.
constexpr double EqualEigenvalues = 1e-6;

/// Whether 1 > l1 >= ... >= ld > l(d+1), inside an object of dimension d: for d = 2 and 3
/// conditions (23) and (24) of Chang and Qin.
Answer HoldsInside(const std::vector<double>& moduli, int dimension);

/// Condition (23) for a surface that ends in `curves` curves with eigenvalue `along`: one at the
/// boundary, two at a corner. The eigenvalues of the curves must be among the two that lead: if
/// not, the surface folds there.
Answer HoldsBesideCurves(const std::vector<double>& moduli, double along, int curves);

}

#endif
