// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CatmullClarkRowsOfNext.h
 * The rows of Catmull-Clark in the step from the next level, which is not made (SkippedLevel.h).
 */
#ifndef SubdivisionObjects_CatmullClarkRowsOfNext_h
#define SubdivisionObjects_CatmullClarkRowsOfNext_h

#include "Core/Surfaces/Scheme/SkippedLevel.h"

namespace subdivision
{

/// With V vertices, E edges and F quads on this level the rows belong to its vertices, to the
/// points of its edges and of its faces, to the halves of its edges, to the four edges inside each
/// quad, and to its four children.
template <typename Id>
void AppendCatmullClarkRowsOfNext(const SurfaceLevel<Id>& level, const IrregularRows<Id>& others,
  vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

template <typename Id>
void GetCatmullClarkParentsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents);

}

#endif
