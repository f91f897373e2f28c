// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Depth.h
 * How much of a level a step computes. The last level needs less than a level that is refined
 * further, and it is the largest.
 */
#ifndef SubdivisionObjects_Depth_h
#define SubdivisionObjects_Depth_h

namespace subdivision
{

enum class Depth
{
  /// Everything that a further step needs.
  ForRefinement,
  /// Surfaces only, for the last level but one: everything that the last step reads.
  ForLastStep,
  /// Only operators and cells of the output: no faces but the triangle cells, no incidences.
  ForOutput,
  /// Surfaces only: counts, but no faces. SurfaceSteps writes the faces straight into the output.
  ForCounts,
  /// Surfaces only: everything that further steps read, but nothing that limits alone read.
  ForSteps
};

}

#endif
