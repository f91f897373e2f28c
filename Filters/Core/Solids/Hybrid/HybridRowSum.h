// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridRowSum.h
 * Sums the entries of a row by column.
 */
#ifndef SubdivisionObjects_HybridRowSum_h
#define SubdivisionObjects_HybridRowSum_h

#include "Core/Operators/RowBlock.h"

#include <vector>

namespace subdivision
{

/// A small hash table: rows of lattices have up to 27 columns, and some 60 entries come together in
/// them. Columns keep the order in which they first came.
template <typename Id>
class HybridRowSum
{
public:
  HybridRowSum()
    : Slots(128, -1)
  {
  }

  void Add(Id column, double weight)
  {
    int& slot = this->Find(column);
    if (slot >= 0)
    {
      this->Weights[static_cast<std::size_t>(slot)] += weight;
      return;
    }
    slot = static_cast<int>(this->Columns.size());
    this->Columns.push_back(column);
    this->Weights.push_back(weight);
    if (4 * this->Columns.size() > 3 * this->Slots.size())
    {
      this->Grow();
    }
  }
  /// Ends the row of a block, and begins the next one.
  void EndRow(RowBlock<Id>& block)
  {
    this->AddTo(block);
    block.EndRow();
  }
  /// Adds the sums to the row of a block, and forgets them.
  void AddTo(RowBlock<Id>& block)
  {
    for (std::size_t i = 0; i < this->Columns.size(); ++i)
    {
      block.Add(this->Columns[i], this->Weights[i]);
    }
    this->Clear();
  }

private:
  int& Find(Id column)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t i = static_cast<std::size_t>(column) * 0x9E3779B1u >> 7 & mask;
    while (this->Slots[i] >= 0 && this->Columns[static_cast<std::size_t>(this->Slots[i])] != column)
    {
      i = (i + 1) & mask;
    }
    return this->Slots[i];
  }
  void Clear()
  {
    if (8 * this->Columns.size() < this->Slots.size())
    {
      // From the last one on, so that no chain is broken before it is followed.
      for (std::size_t i = this->Columns.size(); i-- > 0;)
      {
        this->Find(this->Columns[i]) = -1;
      }
    }
    else
    {
      std::fill(this->Slots.begin(), this->Slots.end(), -1);
    }
    this->Columns.clear();
    this->Weights.clear();
  }
  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), -1);
    for (std::size_t i = 0; i < this->Columns.size(); ++i)
    {
      this->Find(this->Columns[i]) = static_cast<int>(i);
    }
  }

  std::vector<int> Slots; ///< the place of a column, or -1; their number is a power of two
  std::vector<Id> Columns;
  std::vector<double> Weights;
};

}

#endif
