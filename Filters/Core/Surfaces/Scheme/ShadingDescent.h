// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadingDescent.h
 * Normals for shading at vertices of a surface without tangent plane, from their stars in the limit
 * (ShadingNormals.h).
 */
#ifndef SubdivisionObjects_ShadingDescent_h
#define SubdivisionObjects_ShadingDescent_h

#include "Core/Surfaces/Scheme/SharpPatch.h"

namespace subdivision
{

/// Writes the normals of the vertices of a level that are flagged. `points`: three numbers for each
/// vertex, before they go to the limit. `turned`: as of FindTurnedFaces. In `normals` each of these
/// vertices has a tangent, or zero, which counts where it has no faces.
template <typename Id>
void FindShadingNormals(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const Buffer<unsigned char>& turned,
  const Buffer<unsigned char>& missing, const double* points, double* normals);

}

#endif
