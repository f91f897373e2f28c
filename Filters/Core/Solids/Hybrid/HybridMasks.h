// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridMasks.h
 * What a solid contributes to new points at its corners, edges and quads: both passes of a step,
 * the linear split and the means of weighted centroids, as one row (Mathematics 15).
 */
#ifndef SubdivisionObjects_HybridMasks_h
#define SubdivisionObjects_HybridMasks_h

#include "Core/Cells/CellShapes.h"
#include "Core/Rules/LoopWeights.h"

#include "vtkType.h"

#include <vector>

namespace subdivision
{

/// The weight of a solid, and the share of each of its corners, times this weight.
struct SolidMask
{
  double Weight = 0.;
  double Shares[8] = {};
};

/// One for each local point of the type but centres.
const std::vector<SolidMask>& GetSolidMasks(CellShape shape);

/// By how much a point moves to the mean of what is around it: a vertex of a surface of so many
/// quads and triangles, or a column of so many hexahedra and wedges.
double GetRelaxation(vtkIdType quads, vtkIdType triangles, LoopWeights weights);

}

#endif
