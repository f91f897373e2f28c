// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LoopRowsOfNext.h
 * Loop's rows of the step from the next level, which is not made (SkippedLevel.h).
 */
#ifndef SubdivisionObjects_LoopRowsOfNext_h
#define SubdivisionObjects_LoopRowsOfNext_h

#include "Core/Rules/LoopWeights.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

namespace subdivision
{

/// With V vertices, E edges and F triangles on this level the rows belong to its vertices, to its
/// edges' points, to the halves of its edges, and to the three edges inside each triangle.
template <typename Id>
void AppendLoopRowsOfNext(const SurfaceLevel<Id>& level, LoopWeights weights,
  const IrregularRows<Id>& others, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

}

#endif
