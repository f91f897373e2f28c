// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitStencils.h
 * Where vertices go if a level is refined for ever (Mathematics 8): rows over the vertices of the
 * level.
 *
 * The rows of a vertex v and of the edges at v read nothing but neighbours of v, and from the next
 * step on they repeat: with the local matrix A of v and its edges, the limit of v is w A = w, sum
 * w = 1. Every row of A has at least 1/4 in the column of v, so w is unique. It is found by
 * elimination, or, where v has very many edges, as 1/(1 + |u|) (1, u) with the series
 * u = a + a B + a B B + ..., where a is v's row and B the rows of the edges, both without the
 * column of v: each term is at most 3/4 of the one before it. Both add positive numbers only, so
 * that nothing cancels. For d = 1 this gives 2/3, 1/6, 1/6; for d = 2 Loop's limit mask. Equal
 * neighbourhoods are solved once.
 *
 * The ring of a Blend edge of the input may have members with which it spans no triangle. They are
 * read in the first step only: limit = w (S P). Where creases are semi-sharp, so are the steps
 * until they are smooth: limit = w A_n ... A_1 (S P).
 *
 * In a tet/oct level A acts on the opposites of v in the octahedra around it too; their rows, those
 * of the octahedra's centres, have 1/6 in the column of v.
 */
#ifndef SubdivisionObjects_LimitStencils_h
#define SubdivisionObjects_LimitStencils_h

#include "Core/Operators/SparseRows.h"
#include "Core/Solids/BoxSpline/Refinement.h"
#include "Core/Solids/TetOct/TetOctComplex.h"

#include <memory>
#include <vector>

namespace subdivision
{

/// Sharpness above this is no sharper: after so many steps nothing of what was before is left in
/// double, (3/4)^256 < 1e-31.
constexpr int SharpForever = 256;

/// A level as it is where all edges are singular that are still sharp.
template <typename Id>
struct SharpStage
{
  int Until = 0; ///< it is in force at steps before this one, counted from the level
  subdivision::Strata<Id> Strata;                           ///< rings with carriers
  std::shared_ptr<const Buffer<Id>> TetsAtSpokes = nullptr; ///< of a tet/oct level
};

/// What semi-sharp creases do from a level on.
template <typename Id>
struct SemiSharpStages
{
  Buffer<double> Sharpness;           ///< what is left of it at each edge of the level; else 0
  std::vector<SharpStage<Id>> Stages; ///< by ascending Until; the last is in force after it too
};

/// The limits of all vertices of a level that can be refined (Depth::ForRefinement).
template <typename Id>
SparseRows<Id> BuildLimitRows(const Level<Id>& level, const SemiSharpStages<Id>& creases = {});

template <typename Id>
SparseRows<Id> BuildLimitRows(
  const TetOctLevel<Id>& level, const SemiSharpStages<Id>& creases = {});

/// The limits of some vertices, one row for each.
template <typename Id>
SparseRows<Id> BuildLimitRows(
  const Level<Id>& level, const SemiSharpStages<Id>& creases, const Buffer<Id>& vertices);

}

#endif
