// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DooSabinNext.h
 * The step of the Doo-Sabin scheme from the next level, which is not made (SkippedLevel.h).
 *
 * It needs a level that is closed (IsClosedDual). With C corners there,
 * the next level has C vertices, which have the numbers of these corners, and 4 C corners: C inside
 * old faces, 2 C along sides, C around vertices. Its first C sides are those of the first of these,
 * then come for each old side those between the face along it and the faces around its two ends.
 */
#ifndef SubdivisionObjects_DooSabinNext_h
#define SubdivisionObjects_DooSabinNext_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
StepOfNext<Id> MakeDooSabinStepOfNext();

}

#endif
