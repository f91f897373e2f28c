// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceStars.h
 * Spectra and characteristic maps of dual schemes, which keep no vertex: a face repeats.
 */
#ifndef SubdivisionObjects_FaceStars_h
#define SubdivisionObjects_FaceStars_h

#include "Core/Smoothness/SurfaceStars.h"

namespace subdivision
{

/// How many edges away from the face in the middle the faces of a map are: faces farther away have
/// no effect on them. MapFace maps more faces than ExamineFace looks at.
constexpr int SampledDistance = 3;
constexpr int MappedDistance = 4;

/// How many corners of faces up to a distance there are, for each corner of the one in the middle.
constexpr int CountAroundCorner(int distance)
{
  return (distance + 1) * (distance + 2) / 2;
}

/**
 * ExamineSurface for dual schemes. The corners of the face in the middle count as one edge away
 * from it, their neighbours as two, and so on. Once edges have a quarter of the length, the map is
 * looked at on all faces with a corner between one and two of the long edges away. One period takes
 * all corners that are two edges away to the corners one edge away.
 */
SmoothnessFacts ExamineFace(const SurfaceStar& star, bool samples);

/**
 * MapSurface for dual schemes: the eigenvectors of l1 and l2 of all corners of faces that are up to
 * four edges away from the one in the middle. Its middle is the origin, and the middle of one of
 * its edges lies on the x axis, half a ring away. In the mesh that is mapped all faces
 * are made of corners of the same size, so that a face of k corners has k/4 of the area of a quad.
 */
StarMap MapFace(const SurfaceStar& star, int levels);

}

#endif
