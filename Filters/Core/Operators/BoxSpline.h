// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxSpline.h
 * The weights of control points where all is regular, without a table of polynomials: of the
 * quartic box spline over a triangle, and of bicubic B-splines over a quad (Mathematics 8, 12).
 *
 * A place takes some hundred operations for all weights and first derivatives.
 */
#ifndef SubdivisionObjects_BoxSpline_h
#define SubdivisionObjects_BoxSpline_h

#include "Core/Operators/PatchPowers.h"

namespace subdivision
{

constexpr int BoxSplinePoints = 12;
constexpr int BicubicPoints = 16;

/// Sets the wanted parts of PlaceParts. Control points: the three corners; the points beyond edges
/// k, which begin at corner k; then for each corner k the neighbour of the point beyond edge k, and
/// the neighbour of the point beyond the edge before. u and v are the weights of the second and the
/// third corner.
void WeightBoxSpline(double u, double v, const PatchDirections& directions,
  PlaceDerivatives derivatives, PatchParts& parts);

/// The same for 4 x 4 control points, row by row, the first v first; the quad is between the second
/// and the third ones.
void WeightBicubic(double u, double v, const PatchDirections& directions,
  PlaceDerivatives derivatives, PatchParts& parts);

/// All parts for the four control points of a cubic line.
void WeightCubic(double u, const PatchDirections& directions, PatchParts& parts);

}

#endif
