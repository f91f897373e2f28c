// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchPolynomials.h
 * The limit over a curve segment or triangle with nothing but regular vertices around it, as a
 * polynomial: few neighbourhoods (SheetRows.h) serve a whole mesh, and a place costs a few sums.
 */
#ifndef SubdivisionObjects_PatchPolynomials_h
#define SubdivisionObjects_PatchPolynomials_h

#include "Core/Operators/PatchPowers.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/SheetRows.h"

#include "vtkSMPThreadLocal.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace subdivision
{

class PatchPolynomials
{
public:
  explicit PatchPolynomials(LoopWeights weights)
    : Rows(weights)
  {
  }
  /// The weights of all columns of a key for the first of PatchPowers::Quartic, then for the
  /// second, ...; u and v are the weights of the second and the third corner. The places of the key
  /// are FaceLattice, EdgeLattice or CurveLattice.
  const std::vector<double>& Find(const SheetKey& key);
  /// The same without zeros: a row for each power.
  const SparseRows<int>& FindSparse(const SheetKey& key);
  SheetRows& GetRows() { return this->Rows; }

private:
  SheetRows Rows;
  std::unordered_map<std::uint64_t, std::vector<double>> Found;
  std::unordered_map<std::uint64_t, SparseRows<int>> Sparse;
};

/// What each thread has found, for all that works on levels with the same weights.
class KnownSheetRows
{
public:
  PatchPolynomials& OfThread(LoopWeights weights)
  {
    std::shared_ptr<PatchPolynomials>& rows = this->Rows.Local();
    if (!rows)
    {
      rows = std::make_shared<PatchPolynomials>(weights);
    }
    return *rows;
  }

private:
  vtkSMPThreadLocal<std::shared_ptr<PatchPolynomials>> Rows;
};

}

#endif
