// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DooSabinNext.h
 * The step of the Doo-Sabin scheme from the next level, which is not made (SkippedLevel.h).
 *
 * All functions but CountDooSabin need a level that is closed (IsClosedDual). With C corners there,
 * the next level has C vertices, which have the numbers of these corners, and 4 C corners: C inside
 * old faces, 2 C along sides, C around vertices. Its first C sides are those of the first of these,
 * then come for each old side those between the face along it and the faces around its two ends.
 */
#ifndef SubdivisionObjects_DooSabinNext_h
#define SubdivisionObjects_DooSabinNext_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// The counts of the level after one that was skipped.
template <typename Id>
SurfaceLevel<Id> CountDooSabin(const SurfaceLevel<Id>& skipped);

template <typename Id>
void AppendDooSabinRowsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

template <typename Id>
void GetDooSabinParentsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents);

template <typename Id, typename Out>
void WriteDooSabinOfNext(const SurfaceLevel<Id>& level, Out* ids);

}

#endif
