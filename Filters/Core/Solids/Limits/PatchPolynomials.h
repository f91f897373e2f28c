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

#include <cstdint>
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
  /// second,
  /// ...; u and v are the weights of the second and the third corner. The places of the key are
  /// FaceLattice or CurveLattice.
  const std::vector<double>& Find(const SheetKey& key);

private:
  SheetRows Rows;
  std::unordered_map<std::uint64_t, std::vector<double>> Found;
};

}

#endif
