// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSurfaceNumbers.h
 * Numbers the points and cells of an adaptive surface that is made of a part of a surface as the
 * output of the whole surface numbers them.
 */
#ifndef SubdivisionObjects_AdaptiveSurfaceNumbers_h
#define SubdivisionObjects_AdaptiveSurfaceNumbers_h

#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeOutput.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Surface/SurfaceNumbers.h"

namespace subdivision
{

/**
 * `cells` are the cells of `input`, the mesh that `others` know, and `control` is the level of
 * them from which `mesh` was made; `output` has its cells, with original ids. All partitions call
 * this together.
 *
 * A triangle or vertex is known by its control face or edge and by the path from there, which child
 * of which child. The trees of control faces of others are known in part only, so that counts as in
 * NumberSurface would not do. 48 bytes are sent for each triangle and vertex; four exchanges for
 * each level.
 */
template <typename Id>
WholeNumbers NumberAdaptiveSurface(vtkPolyData* input, const SurfaceCells& cells,
  const SurfaceLevel<Id>& control, const AdaptiveSqrtThree<Id>& mesh,
  const AdaptiveSqrtThreeOutput<Id>& plan, OtherPartitions& others, vtkPolyData* output);

}

#endif
