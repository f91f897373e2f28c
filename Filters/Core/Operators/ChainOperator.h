// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChainOperator.h
 * An operator that makes several steps at once where there is nothing but edges. It is no matrix:
 * after each step values are stored in the type of the array. Its blocks are chains, which fit into
 * a core's own cache from the first step to the last, so that nothing between is written to memory.
 */
#ifndef SubdivisionObjects_ChainOperator_h
#define SubdivisionObjects_ChainOperator_h

#include "Core/Operators/ApplyRows.h"

#include <stdexcept>
#include <vector>

namespace subdivision
{

/// Consecutive edges, each of which ends where the next one starts. Vertices between two of them
/// follow the rule of curves, by these two edges.
struct EdgeRun
{
  vtkIdType FirstEdge;
  vtkIdType Count;
  bool HasEnd; ///< whether the row of its last vertex is one of this block
};

/// What the steps make of some edges, or of some vertices. Each step halves all edges. Its new
/// points follow all points before it, in the order of the edges; the halves of edge e are the
/// edges 2 e and 2 e + 1.
template <typename Id>
struct ChainRows
{
  int Steps;
  vtkIdType NumberOfVertices; ///< before the steps
  vtkIdType NumberOfEdges;
  const Id* Ends; ///< 2 for each edge
  /// Run i goes from the centre of star 2 i to that of star 2 i + 1. If there are no runs, this
  /// block has the rows of the centres.
  const EdgeRun* Runs;
  vtkIdType NumberOfRuns;
  /// Stars: vertices, the centres, and the point next to them on each edge that their rule takes,
  /// which each step brings nearer. Their rows and columns count the places in Columns: first come
  /// all centres, then the points of the first star, and so on.
  int StepsOfStars;
  RingRows<Id> Centres;
  RingRows<Id> Spokes; ///< the edges, one for each of these points
  const Id* Columns;
};

class ChainOperator : public PointOperator
{
public:
  using ChainsView = std::variant<ChainRows<int>, ChainRows<long long>>;
  using ChainUser = std::function<void(const ChainsView&)>;
  /// Passes chains that have each row exactly once, in any order and from several threads.
  virtual void ForEachChains(const ChainUser& use) const = 0;

  void ForEachBlock(const User&) const final
  {
    throw std::logic_error("only ApplyToArrays takes an operator of several steps");
  }
};

/// What ApplyToArrays does with such an operator.
void ApplyChains(const ChainOperator& operation, const std::vector<MovedArray>& arrays);

}

#endif
