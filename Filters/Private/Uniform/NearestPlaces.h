// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NearestPlaces.h
 * The places of a limit that are nearest to given points.
 *
 * A fine level on the limit tells where to begin. From there the squared distance is made smaller
 * by steps of Newton's method, in which weights of corners that would become negative stay 0. Where
 * a search ends on the border of a simplex, it goes on in the other simplices there.
 */
#ifndef SubdivisionObjects_NearestPlaces_h
#define SubdivisionObjects_NearestPlaces_h

#include "Core/Memory/SimplexList.h"
#include "Core/Solids/Limits/PlaceLimits.h"

#include <functional>
#include <vector>

class vtkUnstructuredGrid;

namespace subdivision
{

struct NearestPlace
{
  vtkIdType Simplex = -1;
  std::array<double, 4> Weights{}; ///< of its corners
  double Distance = 0.;
};

/// Steps between `simplices` and the cells of `fine`.
constexpr int NearestLevels = 2;

/// Gives the value and the derivatives (PlaceParts) of each place, three numbers each.
using PlaceValues = std::vector<std::array<std::array<double, 3>, PlaceParts::Count>>;
using EvaluatePlaces = std::function<PlaceValues(const std::vector<NearestPlace>& places)>;

/// `fine`: `simplices` after NearestLevels steps, projected to the limit. Points that are not
/// finite get no simplex.
std::vector<NearestPlace> FindNearestPlaces(const SimplexList& simplices, vtkUnstructuredGrid* fine,
  const std::vector<std::array<double, 3>>& points, const EvaluatePlaces& evaluate);

}

#endif
