// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceStars.h
 * Spectra and characteristic maps of dual schemes, which keep no vertex: what repeats is a face.
 */
#ifndef SubdivisionObjects_FaceStars_h
#define SubdivisionObjects_FaceStars_h

#include "Core/Smoothness/SurfaceStars.h"

namespace subdivision
{

/// How many edges away from the face in the middle others are of which a map consists: what lies
/// farther away has no effect on them. A map has more than what is looked at.
constexpr int SampledDistance = 3;
constexpr int MappedDistance = 4;

/// How many corners of faces up to a distance there are, for each corner of the one in the middle.
constexpr int CountAroundCorner(int distance)
{
  return (distance + 1) * (distance + 2) / 2;
}

/**
 * What ExamineSurface finds in dual schemes. The corners of the face in the middle count as one
 * edge away from it, their neighbours as two, and so on. Once edges have a quarter of the length,
 * the map is looked at on all faces that have a corner between one and two of the long edges away:
 * the period that repeats takes all that is two edges away to what is one edge away.
 */
SmoothnessFacts ExamineFace(const SurfaceStar& star, bool samples);

/**
 * What MapSurface makes in dual schemes: the eigenvectors of l1 and l2 of all corners of faces that
 * are up to four edges away from the one in the middle. Its middle is the origin, and the middle of
 * one of its edges lies on the x axis, half a ring away. In the mesh that is mapped all faces
 * are made of corners of the same size, so that a face of k corners has k/4 of what a quad has.
 */
StarMap MapFace(const SurfaceStar& star, int levels);

}

#endif
