// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellSigns.h
 * Which sides of a solid look outwards.
 */
#ifndef SubdivisionObjects_CellSigns_h
#define SubdivisionObjects_CellSigns_h

#include "Core/Cells/CellShapes.h"

#include <array>
#include <vector>

namespace subdivision
{

/// The corners of a solid; unused ones are zero.
using SolidPlaces = std::array<std::array<double, 3>, 8>;

/// For each face of CellTable 1 if its corners have the order of a right hand around the outward
/// normal of a solid of positive volume, else -1. A wedge is positive if its triangle 012 looks
/// inwards. Children of positive solids are positive.
const std::vector<double>& GetFaceSigns(CellShape shape);

/// The sign of the volume of a solid; 0 if the volume is at most `least` times that of its faces'
/// sides. Corners count from the mean of all.
int FindOrientation(CellShape shape, const SolidPlaces& corners, double least);

}

#endif
