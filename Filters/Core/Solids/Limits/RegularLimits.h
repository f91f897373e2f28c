// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularLimits.h
 * Limit rows of a level that is not made, from the level before.
 *
 * A step keeps the ring of a vertex, and its order. So the limit weights of the vertex, in this
 * order, are the same on all levels, and few vertices have weights of their own: control vertices,
 * and midpoints of control edges, which all parts of the edge share. A midpoint inside a face
 * depends on how the two solids at the face number its corners, and one inside a solid on nothing.
 * The *kind* of a vertex is a number for that.
 */
#ifndef SubdivisionObjects_RegularLimits_h
#define SubdivisionObjects_RegularLimits_h

#include "Core/Operators/BlockOperator.h"

namespace subdivision
{

/// The kinds of the vertices of a level with solids, and of the midpoints of its edges.
template <typename Id>
struct LimitKinds
{
  Buffer<Id> Vertices; ///< empty: there are none yet
  Buffer<Id> Edges;
  /// Limit rows of the level that is one step after the first one.
  SparseRows<Id> Own;

  /// Goes on to the next level, from `level`, which is the first one if there are no kinds yet.
  template <typename Level>
  void Refine(const Level& level);
  /// Finds the weights of the level after the first step.
  template <typename Level>
  void FindOwn(const Level& level);
};

/// Whether a level has solids, so that limits need kinds, and two steps.
template <typename Level>
bool HasSolids(const Level& level);

/// The limits of all vertices of the next level, where nothing is semi-sharp. `level` was made with
/// Depth::ForRefinement, and must outlive the result; `kinds` is not read where it has no solids.
/// In the linear scheme all points stay.
template <typename Level>
BlockOperator<typename Level::IdType> FindNextLimits(
  const Level& level, const LimitKinds<typename Level::IdType>& kinds);

}

#endif
