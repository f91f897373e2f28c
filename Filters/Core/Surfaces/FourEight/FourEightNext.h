// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightNext.h
 * The step of the 4-8 scheme from the next level, which is not made (SkippedLevel.h).
 *
 * All functions but CountFourEight need a level without fixed edges and without irregular vertices.
 * With V vertices, E edges and F faces there, the next level has V + F vertices and the E quads
 * across edges; the level after it has E vertices more, and one face for each spoke: between two
 * quads that are neighbours around a vertex of the level.
 */
#ifndef SubdivisionObjects_FourEightNext_h
#define SubdivisionObjects_FourEightNext_h

#include "Core/Surfaces/FourEight/FourEightTopology.h"

namespace subdivision
{

/// The level after one that was skipped, and so has only its counts: its counts.
template <typename Id>
SurfaceLevel<Id> CountFourEight(const SurfaceLevel<Id>& skipped);

template <typename Id>
void AppendFourEightRowsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

template <typename Id>
void GetFourEightParentsOfNext(
  const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents);

template <typename Id, typename Out>
void WriteFourEightOfNext(const SurfaceLevel<Id>& level, Out* ids);

}

#endif
