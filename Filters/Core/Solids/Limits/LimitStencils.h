// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitStencils.h
 * Limit rows: the limit of each vertex of a level as a weighted sum over vertices of the level
 * (Mathematics 8).
 *
 * The rows of a vertex v and of the edges at v read only v and its neighbours, and in later steps
 * they repeat. They form the local matrix A. The limit of v is w times the values at v and its
 * neighbours, where w A = w and sum w = 1. Every row of A has at least 1/4 in the column of v, so w
 * is unique. It is found by elimination, or, if v has very many edges, as 1/(1 + |u|) (1, u) with
 * the series u = a + a B + a B B + ..., where a is v's row and B the rows of the edges, both
 * without the column of v: each term is at most 3/4 of the one before it. Both ways add
 * non-negative numbers only, so that nothing cancels. For d = 1 this gives 2/3, 1/6, 1/6; for d = 2
 * Loop's limit mask. Equal neighbourhoods are solved once.
 *
 * The ring of a Blend edge of the control mesh may have members with which it spans no triangle.
 * Only the first step reads them: limit = w (S P). While edges or faces are still sharp, the
 * matrices A_i of the steps have blended rows: limit = w A_n ... A_1 (S P).
 *
 * In a tet/oct level A has columns for the opposites of v in the octahedra at v too. Their rows are
 * those of the octahedra's centres, which have 1/6 in the column of v, so that a term of the series
 * is at most 5/6 of the one before it.
 */
#ifndef SubdivisionObjects_LimitStencils_h
#define SubdivisionObjects_LimitStencils_h

#include "Core/Memory/Loops.h"
#include "Core/Operators/SparseRows.h"
#include "Core/Solids/Scheme/SemiSharp.h"
#include "Core/Solids/Scheme/SolidScheme.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace subdivision
{

/// Larger sharpness counts as this: what the weights were this many steps ago no longer matters in
/// double, as (3/4)^256 < 1e-31.
constexpr int SharpForever = 256;

/// The strata of a level in which all edges and faces are singular that are still sharp during some
/// steps.
template <typename Id>
struct SharpStage
{
  int Until = 0;                  ///< they hold for steps before this one, counted from the level
  subdivision::Strata<Id> Strata; ///< rings with carriers
  std::shared_ptr<const Buffer<Id>> TetsAtSpokes = nullptr; ///< SolidScheme.h: GetSpokes
};

/// The semi-sharp edges and faces of a level, and the strata that they cause in later steps.
template <typename Id>
struct SemiSharpStages
{
  Buffer<double> Sharpness;     ///< remaining sharpness of each edge of the level; may be empty
  Buffer<double> FaceSharpness; ///< of each face; may be empty
  std::vector<SharpStage<Id>> Stages; ///< by ascending Until; the last also holds after its Until

  /// What is sharp at each vertex and edge. A sharpness larger than `most` counts as `most`.
  SharpParts ListParts(const SimplicialComplex<Id>& complex, double most = SharpForever) const
  {
    SharpParts parts;
    for (const vtkIdType e : InTurn(this->Sharpness.size()))
    {
      if (this->Sharpness[e] > 0.)
      {
        parts.AddEdge(complex, e, std::min(this->Sharpness[e], most));
      }
    }
    for (const vtkIdType f : InTurn(this->FaceSharpness.size()))
    {
      if (this->FaceSharpness[f] > 0.)
      {
        parts.AddFace(complex, f, std::min(this->FaceSharpness[f], most));
      }
    }
    parts.Sort();
    return parts;
  }
};

/// The limits of all vertices of a level that can be refined (Depth::ForRefinement).
template <typename Level>
SparseRows<typename Level::IdType> BuildLimitRows(
  const Level& level, const SemiSharpStages<typename Level::IdType>& creases = {});

/// The limits of some vertices, one row for each.
template <typename Level>
SparseRows<typename Level::IdType> BuildLimitRows(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases,
  const Buffer<typename Level::IdType>& vertices);

}

#endif
