// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridPlaceRun.h
 * The limit at places of a mesh whose cells keep their types (HybridPlaces.h).
 */
#ifndef SubdivisionObjects_HybridPlaceRun_h
#define SubdivisionObjects_HybridPlaceRun_h

#include "Core/Solids/Hybrid/HybridLevel.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Uniform/UniformSubdivision.h"

#include <vector>

class vtkPointSet;

namespace subdivision
{

/// Finds the limits for which Options.Places asks, on the control level. `sources`: the cell of the
/// input of each cell. Returns false after an error, or if Progress asks to stop.
template <typename Id>
bool FindPlacesKeepingTypes(const HybridLevel<Id>& level, const std::vector<vtkIdType>& sources,
  vtkPointSet* input, const UniformOptions& options, PointArrays& points);

}

#endif
