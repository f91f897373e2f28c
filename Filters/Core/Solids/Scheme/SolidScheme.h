// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidScheme.h
 * The members of a volume scheme. A scheme is a template parameter; without one of them code does
 * not compile.
 *
 * A scheme is a struct template `template <typename Id> struct MyScheme` in a folder of its own, as
 * BoxSplineScheme.h and TetOctScheme.h are. AllSchemes/VolumeSchemes.h lists all of them, and all
 * code that is the same for volume schemes is a template over `typename Scheme`, compiled for each
 * scheme of the list with 32-bit and with 64-bit ids.
 *
 * **Types**
 *  - Id;
 *  - Level: a level. It has the members Complex and Strata, and whatever solids need that are no
 *    tetrahedra;
 *  - ChildRows: the operator of a level that is never made (ChildRows.h), made from its parent.
 *
 * **Numbers**
 *  - Traits: a constant SchemeTraits. A scheme whose step is Refiner.h lists its vertices with
 *    ListVertexSegments (VertexSegments.h).
 *
 * **From level to level**
 *  - Start(control): the control level, from a Level in which all solids are tetrahedra;
 *  - Refine(level, depth): an overload in namespace subdivision;
 *  - GetSolidRows(level), TakeSolidRows(level, stencils): the same (Stencils.h);
 *  - CountSolids(level, counts): adds the solids of a level that are no tetrahedra;
 *  - CountCentres(level): how many vertices of the next level lie inside solids;
 *  - CountSteps(level): the number of steps since the control level; only schemes with pieces know
 *    it.
 *
 * **Cells**
 *  - WriteChildren(level, runs, steps, points, out): the children of a level's cells, or their
 *    children; in a scheme without pieces, where all cells are vertices and lines, after any number
 *    of steps. `points`: after the steps, or null, which only matters for pieces and for out.Signs;
 *  - HasCells(level, runs, cells): whether these cells are the cells of the level;
 *  - FindParents(level, runs, cells): for each child cell the cell whose values it takes; empty
 *    where this is its parent.
 *
 * **Limits** (Core/Solids/Limits)
 *  - GetSpokes(level): numbers beside the strata from which rows get their weights, or null;
 *  - Star: made from a level. The scheme for the rows around a vertex (Limits/LevelStar.h):
 *    GetMasks(); CountSolids(vertex, rule, ring size), how many of the last members of its ring lie
 *    opposite in a solid, which is their carrier; CountFaces(rule, ring size), how many of the
 *    first members of an edge's ring lie on faces, the others in pairs in solids;
 *    GetOppositeEnd(solid, vertex), the opposite vertex; ForEdgesInSolid(solid, vertex, add), the
 *    edges at a vertex; GetEdgeBeyond(solid, vertex, far), the edge from a vertex to the opposite
 *    of another one; HasSpokes(vertex, rule), whether the weights of its row follow from GetSpokes;
 *  - GetTurn(level, solid, triangle): the direction of a face of a solid, seen from outside a
 *    positive solid: 1 if its vertices in this order run counterclockwise, -1 if clockwise. The
 *    solid is named as in FaceTets;
 *  - ControlTets: made from a level and the number of steps since the control level; Find(solid)
 *    gives the control tetrahedron that a solid is a part of.
 */
#ifndef SubdivisionObjects_SolidScheme_h
#define SubdivisionObjects_SolidScheme_h

#include "Core/Solids/Scheme/Level.h"

namespace subdivision
{

/// The scheme of a type of levels; each scheme specialises it.
template <typename Level>
struct SchemeOfLevel;
template <typename Level>
using SchemeOf = typename SchemeOfLevel<Level>::Type;

template <typename Scheme>
LevelCounts CountSimplices(const typename Scheme::Level& level)
{
  LevelCounts counts = CountSimplices(level.Complex);
  counts.Scheme = &Scheme::Traits;
  Scheme::CountSolids(level, counts);
  return counts;
}

}

#endif
