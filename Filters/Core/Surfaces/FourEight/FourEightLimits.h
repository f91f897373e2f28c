// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightLimits.h
 * Limit positions and tangents of the 4-8 scheme (Mathematics 12).
 *
 * A limit reads more than the vertices around a vertex: where all of these are regular
 * (FourEightStar.h), its row is a left eigenvector of one step, in a sector of two. Elsewhere it is
 * the row of a later level, on which they are, times the rows of the steps to it: on the fourth at
 * the latest. These steps are made for a patch around the vertices only (SurfacePatch.h), which is
 * cropped after each one, so that it does not grow.
 */
#ifndef SubdivisionObjects_FourEightLimits_h
#define SubdivisionObjects_FourEightLimits_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// Appends the rows of SurfaceScheme::AppendLimitRows.
template <typename Id>
void AppendFourEightLimits(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  bool modifiedBoundary, LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

}

#endif
