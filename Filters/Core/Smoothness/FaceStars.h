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

/// What ExamineSurface finds in dual schemes.
SmoothnessFacts ExamineFace(const SurfaceStar& star);

/**
 * What MapSurface makes in dual schemes: the eigenvectors of l1 and l2 of all corners of faces that
 * are up to four edges away from the one in the middle. Its middle is the origin, and the middle of
 * one of its edges lies on the x axis, half a ring away. In the mesh that is mapped all faces
 * are made of corners of the same size, so that a face of k corners has k/4 of what a quad has.
 */
StarMap MapFace(const SurfaceStar& star, int levels);

}

#endif
