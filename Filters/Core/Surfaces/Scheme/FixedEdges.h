// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FixedEdges.h
 * Finds the *fixed* edges of sqrt(3) and 4-8. These schemes replace all other edges, so that the
 * topology of a step depends on which edges are sharp. Also, whether any edge is.
 */
#ifndef SubdivisionObjects_FixedEdges_h
#define SubdivisionObjects_FixedEdges_h

#include "Core/Surfaces/Scheme/SkippedLevel.h"

namespace subdivision
{

/**
 * Makes edges without twin and edges with line cells sharp; all other edges keep their tags. Then a
 * vertex that is no corner already becomes smooth (one closed fan without sharp edges), a vertex on
 * a curve (exactly two sharp edges) or a corner (all else).
 */
template <typename Id>
void FixEdges(SurfaceLevel<Id>& level);

/// Whether any edge is sharp. If not, nobody has to walk around vertices to find one.
template <typename Id>
bool HasSharpEdges(const SurfaceTags<Id>& tags)
{
  return !AreAll(tags.Edges.size(), [&tags](vtkIdType e) { return !IsSharp(tags.Edges[e]); });
}

}

#endif
