// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchPolynomials.h
 * The limit over a curve segment or triangle with nothing but regular vertices around it, as a
 * polynomial: few neighbourhoods (SheetRows.h) serve a whole mesh, and a place costs a few sums.
 */
#ifndef SubdivisionObjects_PatchPolynomials_h
#define SubdivisionObjects_PatchPolynomials_h

#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/SheetRows.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace subdivision
{

/// The powers u^i v^j with i + j <= 4: those without v first.
constexpr int PatchPowers = 15;

/// Each of PlaceParts of these powers at a place in a patch, of which u and v are the weights of
/// the second and the third corner. `directions`: how these change with the parameters.
std::array<std::array<double, PatchPowers>, PlaceParts::Count> FindPatchPowers(
  const CornerWeights& at, const std::array<CornerWeights, 3>& directions);

class PatchPolynomials
{
public:
  explicit PatchPolynomials(LoopWeights weights)
    : Rows(weights)
  {
  }
  /// The weights of all columns of a key for the first power, then for the second, ... Its places
  /// are FaceLattice or CurveLattice.
  const std::vector<double>& Find(const SheetKey& key);

private:
  SheetRows Rows;
  std::unordered_map<std::uint64_t, std::vector<double>> Found;
};

}

#endif
