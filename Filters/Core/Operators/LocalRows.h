// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalRows.h
 * The rows of a step at a vertex and at what lies around it, its *items*, as a small matrix A, and
 * the limit of the vertex: w A = w, sum w = 1 (Mathematics 8).
 */
#ifndef SubdivisionObjects_LocalRows_h
#define SubdivisionObjects_LocalRows_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace subdivision
{

/// One row for each item, the first of which is the vertex. Entries are not negative, and each row
/// has a part in the column of the vertex.
class LocalRows
{
public:
  void Add(int column, double weight)
  {
    this->Columns.push_back(column);
    this->Weights.push_back(weight);
  }
  void EndRow() { this->Offsets.push_back(this->Columns.size()); }
  std::size_t GetNumberOfItems() const { return this->Offsets.size() - 1; }

  /// The sum of all rows, each times its weight.
  std::vector<double> Sum(const std::vector<double>& weights) const;
  /// The matrix row by row.
  std::vector<double> Fill() const;
  /// w, one weight for each item: by an elimination that subtracts nothing, or, for many items, for
  /// which elimination in a full matrix takes too long, by a series (LimitStencils.h).
  std::vector<double> FindLimit() const;

private:
  std::vector<double> Eliminate() const;
  std::vector<double> SumSeries() const;
  template <typename Act>
  void ForRow(std::size_t row, const Act& act) const
  {
    for (std::size_t i = this->Offsets[row]; i < this->Offsets[row + 1]; ++i)
    {
      act(static_cast<std::size_t>(this->Columns[i]), this->Weights[i]);
    }
  }

  std::vector<std::size_t> Offsets{ 0 };
  std::vector<int> Columns;
  std::vector<double> Weights;
};

/// The rows of all items as numbers, which name items by their order. Equal ones have equal limit
/// weights.
using Neighbourhood = std::vector<int>;

struct HashNeighbourhood
{
  std::size_t operator()(const Neighbourhood& neighbourhood) const
  {
    std::uint64_t hash = 14695981039346656037u;
    for (int value : neighbourhood)
    {
      hash = (hash ^ static_cast<std::uint64_t>(value)) * 1099511628211u;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/// Bounds the memory for solutions of neighbourhoods; refined levels have fewer.
constexpr std::size_t MostSolutions = 4096;

}

#endif
