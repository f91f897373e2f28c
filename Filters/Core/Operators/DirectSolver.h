// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DirectSolver.h
 * Solves a sparse system by factors of its matrix, where an iteration does not.
 */
#ifndef SubdivisionObjects_DirectSolver_h
#define SubdivisionObjects_DirectSolver_h

#include "vtkType.h"

#include <memory>
#include <vector>

namespace subdivision
{

class DirectSolver
{
public:
  DirectSolver();
  ~DirectSolver();

  /**
   * Factorises a square matrix. `rows` has its rows one after the other: the number of the row, how
   * many entries it has, and the column and weight of each. A row that comes again is left out. One
   * that does not come has a single 1. Returns false where the factors would take more than
   * `mostBytes`, or half a minute; before that is known, only as much memory as the matrix is
   * taken.
   */
  bool Factorise(vtkIdType size, const std::vector<double>& rows, double mostBytes);
  /// Sets a right side to the solution, but for a fraction of 1e-12, which refinement takes away:
  /// so much is added to the diagonal, that singular matrices have factors too. Serial, so that
  /// bits do not depend on threads.
  void Solve(std::vector<double>& values) const;

private:
  struct Factors;
  std::unique_ptr<Factors> Own;
};

}

#endif
