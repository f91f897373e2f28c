// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PatchMinimum.h
 * The least value of a polynomial over a line, triangle or quad.
 *
 * The factors of its Bernstein polynomials are bounds, and factors at corners are values. The part
 * with the smallest bound is halved until no bound is below the least value but for a tolerance.
 */
#ifndef SubdivisionObjects_PatchMinimum_h
#define SubdivisionObjects_PatchMinimum_h

#include <array>

namespace subdivision
{

enum class PatchKind : int
{
  Line,
  Triangle,
  Quad
};

/// A part of a patch: its first corner and the ends of its axes, in the parameters of the patch.
using PatchFrame = std::array<std::array<double, 2>, 3>;

constexpr PatchFrame WholePatch{ { { { 0., 0. } }, { { 1., 0. } }, { { 0., 1. } } } };

/// The factors of a polynomial: the i-th one along the first axis and the j-th along the second is
/// at PatchSide * j + i. Lines have j = 0, triangles i + j <= degree.
constexpr int PatchSide = 9;
using PatchFactors = std::array<double, PatchSide * PatchSide>;

struct PatchMinimum
{
  double Value;
  std::array<double, 2> At;
};

/// Lowers `least` to the least value of a polynomial of a degree of at most 8, but for `tolerance`.
/// Returns false if the polynomial has none below it. `frame` says where the part is.
bool LowerToPatch(PatchKind kind, int degree, const PatchFactors& factors, const PatchFrame& frame,
  double tolerance, PatchMinimum& least);

}

#endif
