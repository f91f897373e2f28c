// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeNext.h
 * The step of the sqrt(3) scheme from the next level, which is not made (SkippedLevel.h).
 *
 * It needs a level without fixed edges and without irregular vertices (FindIrregularVertices).
 * Two steps cut each edge into thirds: with V vertices, C corners and F faces there, the next level
 * has V + F vertices, and a face for each corner; the level after it has C vertices more, one in
 * each of these faces, and nine faces for each face of the level.
 */
#ifndef SubdivisionObjects_SqrtThreeNext_h
#define SubdivisionObjects_SqrtThreeNext_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
StepOfNext<Id> MakeSqrtThreeStepOfNext();

}

#endif
