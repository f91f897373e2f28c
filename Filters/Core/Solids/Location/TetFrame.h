// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetFrame.h
 * Barycentric weights, their gradients, and the orientation of a tetrahedron.
 */
#ifndef SubdivisionObjects_TetFrame_h
#define SubdivisionObjects_TetFrame_h

#include "Core/Memory/Vectors.h"

#include <array>

namespace subdivision
{

/// The three edges at the first corner, for each of them the cross product of the two others, and
/// six times the volume.
struct TetFrame
{
  explicit TetFrame(const double* const corners[4]);

  /// Whether the volume is nothing but rounding.
  bool IsFlat(double least = 1e-14) const;
  /// The weights of the corners that give x, if the tetrahedron is not flat.
  std::array<double, 4> GetWeights(const double x[3]) const;

  const double* First; ///< the first corner
  vectors::Vector Edges[3];
  vectors::Vector Normals[3];
  double Volume;
};

/// Weights of the corners of a tetrahedron that give x; false if it is flat.
bool FindWeightsInTet(const double* const corners[4], const double x[3], double weights[4]);

/// The gradients of these weights as functions of x; false if the tetrahedron is flat.
bool FindGradientsInTet(const double* const corners[4], double gradients[4][3]);

/// The sign of the volume; 0 if six times the volume is at most `least` times the product of the
/// lengths of the three edges at the first corner.
int GetOrientationOfTet(const double* const corners[4], double least = 1e-14);

}

#endif
