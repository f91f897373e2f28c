// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MidedgeLater.h
 * Steps of the midedge scheme from levels after the next one, where the next three are not made.
 *
 * They need a level that is closed (IsClosedDual). With C corners there, the level two steps later
 * has C vertices, which have the numbers of these corners, and 4 C corners: C inside old faces, C
 * around vertices, 2 C along sides. Each side there is one of a corner of the first two kinds, and
 * has the number of that corner. So the level after it has 2 C vertices, and the one four steps
 * later 4 C. SurfaceLevel::Later has where the corners are around their vertices, and the corner at
 * each of these places.
 */
#ifndef SubdivisionObjects_MidedgeLater_h
#define SubdivisionObjects_MidedgeLater_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
StepsOfLater<Id> MakeMidedgeStepsOfLater();

}

#endif
