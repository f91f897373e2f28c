// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightNext.h
 * The step of the 4-8 scheme from the next level, which is not made (SkippedLevel.h).
 *
 * It needs a level without fixed edges and without irregular vertices (FindIrregularVertices).
 * With V vertices, E edges and F faces there, the next level has V + F vertices and the E quads
 * across edges; the level after it has E vertices more, and one face for each spoke: between two
 * quads that are neighbours around a vertex of the level.
 */
#ifndef SubdivisionObjects_FourEightNext_h
#define SubdivisionObjects_FourEightNext_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
StepOfNext<Id> MakeFourEightStepOfNext();

/// Appends the rows of the next level's first vertices in the step from it, which may be made:
/// those of this level's vertices, then those of the vertices in its faces.
template <typename Id>
void AppendFourEightVertices(
  const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows);

}

#endif
