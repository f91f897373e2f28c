// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeValues.h
 * Limits of values at places of curves and surfaces without making a level: the value at a vertex
 * of any level is a sum of values on the level before (BoxSplineLattice.h). Each value is found
 * once, so that neighbouring places, and those of later rounds of a refinement, share nearly all.
 */
#ifndef SubdivisionObjects_LatticeValues_h
#define SubdivisionObjects_LatticeValues_h

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"

#include <array>
#include <vector>

namespace subdivision
{

constexpr int MostLatticeLevels = 50;

template <typename Id>
class LatticeValues
{
public:
  /// `level` is the control level. It must outlive this.
  template <typename LevelType>
  LatticeValues(const LevelType& level, int components)
    : Lattice(level, this->NothingSharp)
    , Components(components)
  {
  }
  LatticeValues(const LatticeValues&) = delete; // one member refers to another
  LatticeValues& operator=(const LatticeValues&) = delete;

  /// Finds the limit at a place of a control vertex, edge or face; `at`: the weights of its
  /// corners, as the complex lists them, multiples of 1/2^MostLatticeLevels. It is not a number
  /// where a rule is unknown, or values are none. `control`: the values at the control vertices,
  /// interleaved, the same in each call.
  void FindLimit(int dimension, Id simplex, const std::array<double, 3>& at, const double* control,
    double* limit);

  /// How many values are kept.
  std::size_t GetSize() const { return this->Size; }
  void Clear();

private:
  struct LevelValues
  {
    VertexNumbers<LatticeVertex<Id>> Numbers;
    std::vector<double> Values;
    LatticeRow<Id> Row; ///< of the value that is being found
  };
  const double* Find(const LatticeVertex<Id>& vertex, int level);

  const SharpSimplices<Id> NothingSharp;
  BoxSplineLattice<Id> Lattice;
  const int Components;
  const double* Control = nullptr;
  std::array<LevelValues, MostLatticeLevels + 1> Levels;
  LatticeRow<Id> Limit;
  std::size_t Size = 0;
};

}

#endif
