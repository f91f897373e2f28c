// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightLater.h
 * Steps of the 4-8 scheme from levels after the next one, where the next three are not made.
 *
 * They need a level of quads without fixed edges and irregular vertices (FindIrregularVertices).
 * With V vertices, F faces, E edges and C corners there, the level two steps later has V + F + E
 * vertices and a face for each *spoke*, from the vertex in a face to that of a corner; the level
 * after it has C vertices more and 2 C faces, one across each side of a spoke's face; the next one
 * has 4 C. SurfaceLevel::Later has C numbers each: of the face of each corner's spoke; of the spoke
 * of each face, 2 corner + (1 if the face begins at the corner's vertex); of the faces across two
 * of the sides of each corner's spoke; and of the first such face that belongs to each spoke's
 * face.
 */
#ifndef SubdivisionObjects_FourEightLater_h
#define SubdivisionObjects_FourEightLater_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
StepsOfLater<Id> MakeFourEightStepsOfLater();

}

#endif
