// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyRowsOfNext.h
 * The modified Butterfly scheme's rows of the step from the next level, which is not made
 * (SkippedLevel.h).
 */
#ifndef SubdivisionObjects_ButterflyRowsOfNext_h
#define SubdivisionObjects_ButterflyRowsOfNext_h

#include "Core/Surfaces/Scheme/SkippedLevel.h"

namespace subdivision
{

/// With V vertices, E edges and F triangles on this level the rows are those of V + E vertices,
/// which stay, of the halves of its edges, and of the three edges inside each triangle.
template <typename Id>
void AppendButterflyRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

}

#endif
