// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchPowers.h
 * Limits over regular parts of a mesh as polynomials of two variables u and v: sums of powers
 * u^i v^j. Few polynomials serve a whole mesh, and a place costs the powers there and a few sums
 * for each column.
 */
#ifndef SubdivisionObjects_PatchPowers_h
#define SubdivisionObjects_PatchPowers_h

#include "Core/Operators/PlaceParts.h"

#include <array>
#include <cstddef>

namespace subdivision
{

/// Which powers there are: first powers of u alone, then their products with v, ...
enum class PatchPowers : unsigned char
{
  Quartic, ///< i + j <= 4: over triangles and lines
  Bicubic  ///< i, j <= 3: over quads
};

constexpr int QuarticPowers = 15;
constexpr int BicubicPowers = 16;
constexpr int MostPatchPowers = 16;

constexpr int CountPowers(PatchPowers kind)
{
  return kind == PatchPowers::Quartic ? QuarticPowers : BicubicPowers;
}
/// The number of a power.
constexpr int NumberPower(PatchPowers kind, int i, int j)
{
  return kind == PatchPowers::Quartic ? 5 * j - j * (j - 1) / 2 + i : 4 * j + i;
}

/// One factor for each power.
using PatchPolynomial = std::array<double, MostPatchPowers>;

/// Multiplies by a + b u + c v. Terms beyond the highest powers are left out.
PatchPolynomial MultiplyByLinear(
  PatchPowers kind, const PatchPolynomial& polynomial, double a, double b, double c);

/// How u and v change with the parameters of a cell: u with the first and the second one, then v.
using PatchDirections = std::array<std::array<double, 2>, 2>;

/// Each of PlaceParts of up to so many functions at a place.
using PatchParts = std::array<std::array<double, MostPatchPowers>, PlaceParts::Count>;

/// Of the powers.
PatchParts FindPatchPowers(PatchPowers kind, double u, double v, const PatchDirections& directions);

/// Of polynomials: `polynomials` are the factors of all columns for the first power, then for the
/// second, ...; each of `sums` that is wanted gets one number for each column.
void SumPowers(PatchPowers kind, const PatchParts& powers, const double* polynomials,
  std::size_t columns, const PlaceSums& sums);

}

#endif
