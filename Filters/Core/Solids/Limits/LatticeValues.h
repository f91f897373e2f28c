// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeValues.h
 * Limits of values at vertices of any level without making one: the value at a vertex is a sum of
 * values on the level before (SharpLattice.h). Each value is found once, so that neighbouring
 * vertices, and vertices of later rounds of a refinement, share nearly all.
 */
#ifndef SubdivisionObjects_LatticeValues_h
#define SubdivisionObjects_LatticeValues_h

#include "Core/Memory/Ids.h"
#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/SharpLattice.h"

#include <algorithm>
#include <deque>
#include <limits>
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
  void FindLimit(const LatticeVertex<Id>& vertex, int level, const double* control, double* limit)
  {
    this->Control = control;
    while (static_cast<int>(this->Levels.size()) <= level)
    {
      this->Levels.emplace_back();
    }
    const bool isKnown = this->Lattice->ReadLimit(vertex, this->Limit);
    std::fill_n(limit, this->Components, isKnown ? 0. : std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; isKnown && k < this->Limit.Vertices.size(); ++k)
    {
      const double* value = this->Find(this->Limit.Vertices[k], level);
      for (int c = 0; c < this->Components; ++c)
      {
        limit[c] += this->Limit.Weights[k] * value[c];
      }
    }
  }

  /// How many values are kept.
  std::size_t GetSize() const { return this->Size; }
  void Clear()
  {
    this->Levels.clear();
    this->Size = 0;
  }

private:
  struct LevelValues
  {
    VertexNumbers<LatticeVertex<Id>> Numbers;
    std::vector<double> Values;
    LatticeRow<Id> Row; ///< of the value that is being found
  };
  const double* Find(const LatticeVertex<Id>& vertex, int level)
  {
    if (level == 0)
    {
      return this->Control + vtkIdType(this->Components) * vertex.GetColumn();
    }
    LevelValues& on = this->Levels[static_cast<std::size_t>(level)];
    const auto size = static_cast<std::size_t>(this->Components);
    const std::size_t first = size * on.Numbers.GetNumber(vertex);
    if (first < on.Values.size())
    {
      return on.Values.data() + first;
    }
    ++this->Size;
    const bool isKnown = this->Lattice->ReadRow(vertex, on.Row);
    on.Values.resize(first + size, isKnown ? 0. : std::numeric_limits<double>::quiet_NaN());
    double* sums = on.Values.data() + first; // stays: sums are over values of earlier levels
    for (std::size_t k = 0; isKnown && k < on.Row.Vertices.size(); ++k)
    {
      const double* value = this->Find(on.Row.Vertices[k], level - 1);
      for (std::size_t c = 0; c < size; ++c)
      {
        sums[c] += on.Row.Weights[k] * value[c];
      }
    }
    return sums;
  }

  const std::shared_ptr<typename LevelLattices<LevelType>::Lattice> Lattice;
  const int Components;
  const double* Control = nullptr;
  std::deque<LevelValues> Levels;
  LatticeRow<Id> Limit;
  std::size_t Size = 0;
};

}

#endif
