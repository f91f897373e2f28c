// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MidedgeNext.h
 * The step of the midedge scheme from the next level, which is not made (SkippedLevel.h).
 *
 * It needs a level that is closed (IsClosedDual). Each side of the next
 * level then lies across one corner of this one, and has its number: between the faces inside the
 * corner's face and around the vertex at its half-edge's end.
 */
#ifndef SubdivisionObjects_MidedgeNext_h
#define SubdivisionObjects_MidedgeNext_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
StepOfNext<Id> MakeMidedgeStepOfNext();

}

#endif
