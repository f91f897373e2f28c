// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MidedgeNext.h
 * The step of the midedge scheme from the next level, which is not made (SkippedLevel.h).
 *
 * All functions but CountMidedge need a level that is closed (IsClosedDual). Each side of the next
 * level then lies across one corner of this one, and has its number: between the faces inside the
 * corner's face and around the vertex at its half-edge's end.
 */
#ifndef SubdivisionObjects_MidedgeNext_h
#define SubdivisionObjects_MidedgeNext_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// The counts of the level after one that was skipped.
template <typename Id>
SurfaceLevel<Id> CountMidedge(const SurfaceLevel<Id>& skipped);

template <typename Id>
void AppendMidedgeRowsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

template <typename Id>
void GetMidedgeParentsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents);

template <typename Id, typename Out>
void WriteMidedgeOfNext(const SurfaceLevel<Id>& level, Out* ids);

}

#endif
