// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeValues.h
 * Limits of values at vertices of any level without making one: the value at a vertex is a sum of
 * values on the level before (SharpLattice.h). Each value is found once, so that neighbouring
 * vertices, and vertices of later rounds of a refinement, share nearly all.
 */
#ifndef SubdivisionObjects_LatticeValues_h
#define SubdivisionObjects_LatticeValues_h

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/SharpLattice.h"

#include <deque>
#include <memory>
#include <vector>

namespace subdivision
{

/// Threads have one each.
template <typename LevelType>
class LatticeValues
{
public:
  using Id = typename LevelType::IdType;

  /// `lattices` must outlive this.
  LatticeValues(const LevelLattices<LevelType>& lattices, int components)
    : Lattice(lattices.Make())
    , Components(components)
  {
  }

  /// Finds the limit of a vertex of a level. It is not a number where a rule is unknown. `control`:
  /// the values at the control vertices, interleaved, the same in each call.
  void FindLimit(const LatticeVertex<Id>& vertex, int level, const double* control, double* limit);

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

  const std::shared_ptr<typename LevelLattices<LevelType>::Lattice> Lattice;
  const int Components;
  const double* Control = nullptr;
  std::deque<LevelValues> Levels;
  LatticeRow<Id> Limit;
  std::size_t Size = 0;
};

}

#endif
