// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Coordinates.h
 * Coordinates in double, with the tolerance for comparing lengths and angles made of them. Lattices
 * have exact ties of lengths, which rounding would break (Mathematics 2).
 */
#ifndef SubdivisionObjects_Coordinates_h
#define SubdivisionObjects_Coordinates_h

namespace subdivision
{

/// Lengths that differ relatively by no more than this tie: for points in double and in single
/// precision.
constexpr double DoubleTie = 1e-9;
constexpr double SingleTie = 1e-5;

/// The largest relative error of a number that was rounded to double, 2^-53, and to single
/// precision.
constexpr double DoubleUnit = 1.1102230246251565e-16;
constexpr double SingleUnit = 5.9604644775390625e-8;

/// Three numbers for each point, and the relative difference up to which lengths tie.
struct Coordinates
{
  Coordinates(const double* values, double tie = DoubleTie)
    : Values(values)
    , Tie(tie)
  {
  }
  operator const double*() const { return this->Values; }
  /// The largest relative error of a coordinate that was stored.
  double GetUnit() const { return this->Tie > DoubleTie ? SingleUnit : DoubleUnit; }

  const double* Values;
  double Tie;
};

}

#endif
