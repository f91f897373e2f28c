// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Depth.h
 * How much of a level is made: the last one needs less than those that are refined further.
 */
#ifndef SubdivisionObjects_Depth_h
#define SubdivisionObjects_Depth_h

namespace subdivision
{

enum class Depth
{
  /// Everything that a further step needs.
  ForRefinement,
  /// Of surfaces: everything that the last step needs, whose level is ForOutput.
  ForLastStep,
  /// Only what moves points and writes cells: no faces but the triangle cells, no incidences.
  ForOutput,
  /// Of surfaces: not even these, because they are written where they are to be.
  ForCounts
};

}

#endif
