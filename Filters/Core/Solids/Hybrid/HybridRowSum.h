// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridRowSum.h
 * Sums the entries of a row by column.
 */
#ifndef SubdivisionObjects_HybridRowSum_h
#define SubdivisionObjects_HybridRowSum_h

#include "Core/Operators/RowBlock.h"
#include "Core/Operators/VertexRow.h"

#include <vector>

namespace subdivision
{

/// Columns keep the order in which they first came.
template <typename Id>
class HybridRowSum
{
public:
  void Add(Id column, double weight)
  {
    const std::size_t number = this->Columns.GetNumber(column);
    if (number == this->Weights.size())
    {
      this->Weights.push_back(0.);
    }
    this->Weights[number] += weight;
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
    for (std::size_t i = 0; i < this->Weights.size(); ++i)
    {
      block.Add(this->Columns.Vertices[i], this->Weights[i]);
    }
    this->Columns.Clear();
    this->Weights.clear();
  }

private:
  VertexNumbers<Id> Columns;
  std::vector<double> Weights;
};

}

#endif
