// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightRim.h
 * Makes a patch of a 4-8 level a level that steps can refine.
 */
#ifndef SubdivisionObjects_FourEightRim_h
#define SubdivisionObjects_FourEightRim_h

#include "Core/Surfaces/Scheme/SurfacePatch.h"

namespace subdivision
{

/**
 * Edges where the patch ends and the whole level goes on get a face beyond, of new vertices: even
 * steps need that a fixed edge belongs to a triangle which has no other one. Over an edge ab stands
 * a triangle abd with a vertex m in its middle, that is, three triangles, of which two have a fixed
 * edge. Edges of the whole level have its tags. Only the surroundings of vertices inside have
 * anything to do with the whole level.
 */
template <typename Id>
void CloseRim(const SurfaceLevel<Id>& whole, SurfacePatch<Id>& patch);

}

#endif
