// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfacePlaces.h
 * Limits at any place of faces and lines by Loop or Catmull-Clark, with derivatives (Mathematics 8,
 * 12).
 *
 * Where all is regular around a face the limit over it is a polynomial (RegularPatch.h). Inside of
 * a regular surface a place costs no more than the weights of its control points. Any other
 * face is split by a step of its surroundings alone (SharpPatch.h), and the part with the place is
 * looked at, until it is regular. The common data of the places of a face is made once. At corners
 * of parts limits are limits of vertices.
 */
#ifndef SubdivisionObjects_SurfacePlaces_h
#define SubdivisionObjects_SurfacePlaces_h

#include "Core/Operators/PlaceParts.h"
#include "Core/Surfaces/Scheme/SharpPatch.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
struct SurfacePlace
{
  int Dimension = 0; ///< 0: of a vertex, 1: of an edge without faces, 2: of a face
  Id Part = 0;       ///< the number of the vertex, edge or face
  /// In a face that has not the number of corners of the scheme: at which of its corners the place
  /// is, in the quad that the next level has there. Otherwise -1.
  int Corner = -1;
  /// x and y, as RegularPatch.h has them, and their derivatives by the two parameters.
  std::array<double, 2> At{ { 0., 0. } };
  std::array<std::array<double, 2>, 2> Directions{ { { { 1., 0. } }, { { 0., 1. } } } };
};

/// A part is split so many times at most, each of which makes it less than 0.7 times as large: then
/// only its corners are wanted.
constexpr int MostSurfaceSplits = 100;
/// At a corner of parts that are not regular, derivatives are taken of the patch between the limits
/// of the corners after so many splits, in the tangent plane of an extraordinary vertex.
constexpr int SplitsAtCorners = 26;

/// `level` has been prepared. `creases`: that are sharp on it. The row of a place depends neither
/// on other places nor on the wanted derivatives.
template <typename Id>
PlaceRows<Id> FindSurfacePlaces(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
  const SharpCreases<Id>& creases, const std::vector<SurfacePlace<Id>>& places,
  PlaceDerivatives derivatives);

}

#endif
