// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FixedEdges.h
 * Curves in schemes that replace the other edges (sqrt(3), 4-8): there the topology depends on
 * which edges are sharp.
 */
#ifndef SubdivisionObjects_FixedEdges_h
#define SubdivisionObjects_FixedEdges_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/**
 * Edges without a twin and edges that carry line cells become sharp, all others keep their tags; a
 * vertex is smooth (one closed fan, no sharp edge), on a curve (exactly two sharp edges) or a
 * corner.
 */
template <typename Id>
void FixEdges(SurfaceLevel<Id>& level);

}

#endif
